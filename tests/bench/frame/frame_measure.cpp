// frame_measure.cpp - contenders, rounds, and medians into cases.
#include "frame/frame_measure.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include "frame/checksum.hpp"
#include "frame/frame_peer.hpp"
#include "timing.hpp"

namespace bench {
namespace {

// rsh in one column, with its times of each round.
struct Contender {
    Column column;
    std::unique_ptr<RshTracer> tracer;
    size_t mismatches = 0;
    std::string hits_checksum;  // of the checked moment, whatever the number of rounds
    FrameWork work;
    nlohmann::json differences = nlohmann::json::object();  // from the peers' answers
    std::vector<double> total_ms, bound_ms, build_ms, traverse_ms;

    // A wrong answer has no speed; seconds per frame tell all there is to tell after one round.
    bool is_done() const {
        return mismatches > 0 || (!total_ms.empty() && total_ms.back() > kSlowMs);
    }
    static constexpr double kSlowMs = 1500;
};

class RowRun {
public:
    RowRun(const Device& device, SceneOnDevice& scene, const FrameRow& row)
        : device_(device),
          scene_(scene),
          row_(row),
          is_shadow_(row.rays == RayKind::kShadow),
          rays_(device, row.size) {}

    size_t start(const std::vector<Column>& columns);
    void check();
    void time(const RowSettings& settings);
    std::vector<Case> cases() const;

private:
    void check(Contender& contender);
    void time_round(double moment);
    void put_times(const Contender& contender, nlohmann::json& metrics) const;
    nlohmann::json metrics(const Contender& contender) const;
    nlohmann::json params(const Contender& contender) const;

    const Device& device_;
    SceneOnDevice& scene_;
    const FrameRow& row_;
    bool is_shadow_;
    RayMaker rays_;
    size_t active_rays_ = 0;
    std::vector<std::unique_ptr<FramePeer>> peers_;
    std::vector<Contender> contenders_;
};

// Shuffled rays are a list.
Size shape_of(const FrameRow& row) {
    if (row.rays != RayKind::kShuffled) return row.size;
    return {static_cast<cl_uint>(row.size.pixels()), 1};
}

constexpr double kCheckedMoment = 0.3, kEarlierMoment = 1.2;

// Returns the number of active rays.
size_t RowRun::start(const std::vector<Column>& columns) {
    scene_.move(kCheckedMoment);
    rays_.make(scene_, row_.rays);
    active_rays_ = rays_.active_count();
    if (active_rays_ == 0) return 0;
    peers_ = make_frame_peers(device_, scene_, rays_, is_shadow_);
    for (const Column& column : columns) {
        contenders_.emplace_back();
        contenders_.back().column = column;
        contenders_.back().tracer = std::make_unique<RshTracer>(
            device_, scene_.geometry(), shape_of(row_), is_shadow_, column);
    }
    return active_rays_;
}

void RowRun::check() {
    for (const auto& peer : peers_) peer->answer();
    for (Contender& contender : contenders_) check(contender);
}

// A refit is checked on bounds that were made of another moment.
void RowRun::check(Contender& contender) {
    if (contender.column.is_refit) {
        scene_.move(kEarlierMoment);
        contender.tracer->trace(rays_.buffer());
        scene_.move(kCheckedMoment);
    }
    contender.tracer->trace(rays_.buffer());
    contender.mismatches = contender.tracer->mismatches();
    if (is_shadow_) {
        const auto ours = contender.tracer->occlusion();
        contender.hits_checksum = checksum(ours);
        for (const auto& peer : peers_) peer->compare_occlusion(ours, contender.differences);
    } else {
        const auto ours = contender.tracer->hits();
        contender.hits_checksum = checksum(ours);
        for (const auto& peer : peers_) peer->compare(ours, contender.differences);
    }
    contender.work = contender.tracer->count(rays_.buffer(), active_rays_);
}

void RowRun::time_round(double moment) {
    scene_.move(moment);
    rays_.make(scene_, row_.rays);
    for (Contender& contender : contenders_) {
        if (contender.is_done()) continue;
        let_threads_sleep();
        const FrameTimes times = contender.tracer->trace(rays_.buffer());
        contender.total_ms.push_back(times.total);
        contender.bound_ms.push_back(times.bound);
        contender.build_ms.push_back(times.build);
        contender.traverse_ms.push_back(times.traverse);
    }
    for (const auto& peer : peers_) peer->time_round();
}

void RowRun::time(const RowSettings& settings) {
    constexpr size_t kMostRounds = 25;
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (size_t round = 0; round < kMostRounds; ++round) {
        const bool is_done = std::all_of(contenders_.begin(), contenders_.end(),
                                         [](const Contender& c) { return c.is_done(); });
        if (is_done || (round >= settings.min_rounds && passed() > settings.seconds)) break;
        time_round(0.3 + 0.618 * double(round));
    }
}

nlohmann::json RowRun::params(const Contender& contender) const {
    return {{"scene", row_.scene.name},
            {"triangles", scene_.geometry().triangle_count},
            {"width", row_.size.width},
            {"height", row_.size.height},
            {"rays", name_of(row_.rays)},
            {"active_rays", active_rays_},
            {"engine", contender.column.engine_name},
            {"bound", contender.column.bound_name},
            {"refit", contender.column.is_refit}};
}

void RowRun::put_times(const Contender& c, nlohmann::json& metrics) const {
    const Spread total = spread(c.total_ms);
    metrics.update({{"ms_total", total.median},
                    {"ms_total_low", total.low},
                    {"ms_total_high", total.high},
                    {"ms_bound", spread(c.bound_ms).median},
                    {"ms_build", spread(c.build_ms).median},
                    {"ms_traverse", spread(c.traverse_ms).median},
                    {"rounds", c.total_ms.size()}});
    for (const auto& peer : peers_) peer->put_times(c.total_ms, metrics);
}

nlohmann::json RowRun::metrics(const Contender& c) const {
    nlohmann::json metrics = {{"tests_per_ray", c.work.tests_per_ray},
                              {"pairs_peak", c.work.peak_pairs},
                              {"bytes_peak", c.tracer->bytes()},
                              {"launches", c.work.launches},
                              {"mismatches", c.mismatches},
                              {"hits_checksum", c.hits_checksum}};
    metrics.update(c.differences);
    if (c.mismatches == 0) put_times(c, metrics);
    return metrics;
}

std::vector<Case> RowRun::cases() const {
    std::vector<Case> cases;
    for (const Contender& contender : contenders_)
        cases.push_back({case_name(row_, contender.column), params(contender),
                         metrics(contender), contender.mismatches == 0});
    return cases;
}

}  // namespace

std::vector<Case> measure_row(const Device& device, SceneOnDevice& scene, const FrameRow& row,
                              const std::vector<Column>& columns, const RowSettings& settings) {
    if (row.rays == RayKind::kShadow && scene.frame_scene().point_light() < 0) return {};
    RowRun run(device, scene, row);
    if (run.start(columns) == 0) return {};
    run.check();
    run.time(settings);
    return run.cases();
}

}  // namespace bench
