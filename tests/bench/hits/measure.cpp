#include "hits/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "hits/errors.hpp"
#include "hits/hits_text.hpp"
#include "timing.hpp"

namespace bench::hits {
namespace {

stability::Extent extent_of(const SceneKind& kind, const Amount& amount) {
    return {amount.extent.side * kind.times, amount.extent.triangles};
}

struct Entry {
    const ContenderKind& kind;
    std::unique_ptr<Contender> contender;
    nlohmann::json metrics = nlohmann::json::object();
    bool is_wrong = false;
    std::string why_left_out = {};
    std::vector<double> ms = {};

    // A wrong answer of rsh has no speed; seconds per frame tell all there is to tell after one.
    bool is_done() const {
        constexpr double kSlowMs = 1500;
        return !contender || is_wrong || !why_left_out.empty() ||
               (!ms.empty() && ms.back() > kSlowMs);
    }
};

class SceneRun {
public:
    SceneRun(const Run& run, const SceneKind& kind, const Amount& amount)
        : run_(run),
          kind_(kind),
          amount_(amount),
          scene_(kind.make(run.device, extent_of(kind, amount))),
          on_device_(run.device, scene_),
          expected_(stability::expected_answers(
              scene_, kind.is_closed ? stability::Kind::kClosed : stability::Kind::kAimed,
              size_t(amount.decisions / scene_.mesh.triangle_count()))) {}

    void check(const std::vector<ContenderKind>& contenders);
    void time();
    void hand_in();

private:
    std::string why_not(const ContenderKind& kind) const;
    void check(Entry& entry);
    void put_times(Entry& entry) const;

    const Run& run_;
    const SceneKind& kind_;
    const Amount& amount_;
    const stability::Scene scene_;
    const DeviceScene on_device_;
    const stability::Expected expected_;
    std::vector<rsh_hit> reference_;  // of the first of rsh's contenders
    std::vector<Entry> entries_;
};

std::string SceneRun::why_not(const ContenderKind& kind) const {
    if (run_.limit.has_passed()) return run_.limit.when_passed();
    const double pairs = double(scene_.rays.rays.size()) * double(scene_.mesh.triangle_count());
    if (!kind.is_stream || pairs <= amount_.pairs) return {};
    if (kind_.is_coherent && !kind.is_yardstick) return {};
    return fmt::format("{:.2g} pairs of a ray and a triangle, at most {:.2g}", pairs,
                       amount_.pairs);
}

void SceneRun::check(const std::vector<ContenderKind>& contenders) {
    for (const ContenderKind& kind : contenders) {
        entries_.push_back({kind, nullptr});
        Entry& entry = entries_.back();
        entry.why_left_out = why_not(kind);
        if (!entry.why_left_out.empty()) continue;
        try {
            check(entry);
        } catch (const std::exception& error) {
            entry.is_wrong = true;
            entry.metrics["error"] = describe_error(error);
        }
    }
}

void SceneRun::check(Entry& entry) {
    entry.contender = entry.kind.make(on_device_);
    entry.contender->trace();
    const std::vector<rsh_hit> hits = entry.contender->hits();
    const Errors errors = count_errors(scene_, expected_, kind_.is_closed, hits);
    errors.put(entry.metrics);
    if (entry.kind.is_peer) return;
    if (reference_.empty()) reference_ = hits;
    const uint64_t differ = count_differing(scene_.rays.rays, reference_, hits);
    entry.metrics["differ"] = differ;
    entry.is_wrong = errors.all() + differ > 0;
}

void SceneRun::time() {
    constexpr size_t kMostRounds = 25;
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (size_t round = 0; round < kMostRounds; ++round) {
        const bool is_done = std::all_of(entries_.begin(), entries_.end(),
                                         [](const Entry& entry) { return entry.is_done(); });
        if (is_done || (round >= amount_.min_rounds && passed() > amount_.seconds)) break;
        if (round > 0 && run_.limit.has_passed()) break;
        for (Entry& entry : entries_) {
            if (entry.is_done()) continue;
            let_threads_sleep();
            entry.ms.push_back(entry.contender->trace());
        }
    }
}

// Ratios within a round, to each peer: above 1, this contender is quicker.
void SceneRun::put_times(Entry& entry) const {
    const Spread ms = spread(entry.ms);
    entry.metrics.update({{"ms_total", ms.median},
                          {"ms_low", ms.low},
                          {"ms_high", ms.high},
                          {"rounds", entry.ms.size()}});
    entry.contender->describe(entry.metrics);
    for (const Entry& peer : entries_) {
        if (!peer.kind.is_peer || &peer == &entry) continue;
        std::vector<double> ratios;
        for (size_t i = 0; i < std::min(entry.ms.size(), peer.ms.size()); ++i)
            ratios.push_back(peer.ms[i] / entry.ms[i]);
        if (ratios.empty()) continue;
        std::string key = "ratio_" + peer.kind.label;
        std::replace(key.begin(), key.end(), '/', '_');
        entry.metrics[key] = spread(ratios).median;
    }
}

void SceneRun::hand_in() {
    for (Entry& entry : entries_) {
        const std::string name = case_name(kind_, amount_, entry.kind);
        if (!entry.is_wrong && !entry.why_left_out.empty()) {
            run_.results.leave_out(name, entry.why_left_out);
            continue;
        }
        if (!entry.is_wrong) put_times(entry);
        const Case done = {name,
                           {{"scene", kind_.name},
                            {"group", kind_.group},
                            {"triangles", scene_.mesh.triangle_count()},
                            {"rays", scene_.rays.rays.size()},
                            {"contender", entry.kind.label},
                            {"peer", entry.kind.is_peer}},
                           entry.metrics,
                           !entry.is_wrong};
        fmt::print("{}", as_text(done));
        run_.results.add(done);
    }
}

}  // namespace

std::string case_name(const SceneKind& scene, const Amount& amount,
                      const ContenderKind& contender) {
    const uint32_t side = extent_of(scene, amount).side;
    return fmt::format("hits/scene:{}/size:{}x{}/{}", scene.name, side, side, contender.name);
}

void measure_scene(const Run& run, const SceneKind& kind,
                   const std::vector<ContenderKind>& contenders, const Amount& amount) {
    SceneRun scene(run, kind, amount);
    scene.check(contenders);
    scene.time();
    scene.hand_in();
}

}  // namespace bench::hits
