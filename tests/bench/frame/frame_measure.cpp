// frame_measure.cpp - contenders, rounds, and medians into cases.
#include "frame/frame_measure.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "frame/checksum.hpp"
#include "frame/embree_check.hpp"
#include "timing.hpp"

namespace bench {
namespace {

// Workers of a thread pool spin for a while after their last task. Whoever comes next must not
// share the cores with them.
void let_threads_sleep() {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
}

// Embree built in one way, with its times of each round.
struct Embree {
    EmbreeBuild build;
    std::unique_ptr<EmbreePeer> peer;
    PacketMode mode{16, true};
    std::vector<double> build_ms, trace_ms, total_ms;
};

// rsh in one column, likewise.
struct Contender {
    Column column;
    std::unique_ptr<RshTracer> tracer;
    size_t mismatches = 0;
    std::string hits_checksum;  // of the checked moment, whatever the number of rounds
    FrameWork work;
    DifferenceCounts differences;
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
          rays_(device, row.size),
          hits_(row.size.pixels()),
          masks_(row.size.pixels()) {}

    size_t start(const std::vector<Column>& columns);
    void check();
    void time(const RowSettings& settings);
    std::vector<Case> cases() const;

private:
    double trace_embree(Embree& embree, PacketMode mode);
    void choose_mode(Embree& embree);
    void check(Contender& contender);
    void time_round(double moment);
    const Embree& best_rebuild() const;
    void put_times(const Contender& contender, nlohmann::json& metrics) const;
    nlohmann::json metrics(const Contender& contender) const;
    nlohmann::json params(const Contender& contender) const;

    const Device& device_;
    SceneOnDevice& scene_;
    const FrameRow& row_;
    bool is_shadow_;
    RayMaker rays_;
    size_t active_rays_ = 0;
    std::vector<rsh_hit> hits_;  // Embree's
    std::vector<cl_uint> masks_;
    std::vector<Embree> embrees_;
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
    const auto threads = device_.device().getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    for (const EmbreeBuild build :
         {EmbreeBuild::kLow, EmbreeBuild::kMedium, EmbreeBuild::kRefit})
        embrees_.push_back({build,
                            std::make_unique<EmbreePeer>(scene_, build, threads),
                            {16, true},
                            {},
                            {},
                            {}});
    for (Embree& embree : embrees_) choose_mode(embree);
    for (const Column& column : columns) {
        contenders_.emplace_back();
        contenders_.back().column = column;
        contenders_.back().tracer = std::make_unique<RshTracer>(
            device_, scene_.geometry(), shape_of(row_), is_shadow_, column);
    }
    return active_rays_;
}

double RowRun::trace_embree(Embree& embree, PacketMode mode) {
    return milliseconds([&] {
        if (is_shadow_)
            embree.peer->occlude(rays_, mode, masks_);
        else
            embree.peer->trace(rays_, mode, hits_);
    });
}

// Embree gets what is quickest for these rays: packets or single rays, either flag.
void RowRun::choose_mode(Embree& embree) {
    double best = 1e30;
    for (const PacketMode mode :
         {PacketMode{16, true}, PacketMode{16, false}, PacketMode{8, true},
          PacketMode{8, false}, PacketMode{1, false}}) {
        const double ms = std::min(trace_embree(embree, mode), trace_embree(embree, mode));
        if (ms >= best) continue;
        best = ms;
        embree.mode = mode;
    }
}

void RowRun::check() {
    trace_embree(embrees_.front(), embrees_.front().mode);
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
        contender.differences =
            compare_occlusion(device_, scene_, rays_, ours, *embrees_.front().peer, masks_);
    } else {
        const auto ours = contender.tracer->hits();
        contender.hits_checksum = checksum(ours);
        contender.differences = compare_hits(scene_, rays_, ours, hits_);
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
    for (Embree& embree : embrees_) {
        let_threads_sleep();
        embree.build_ms.push_back(milliseconds([&] { embree.peer->build(); }));
        embree.trace_ms.push_back(trace_embree(embree, embree.mode));
        embree.total_ms.push_back(embree.build_ms.back() + embree.trace_ms.back());
    }
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

const Embree& RowRun::best_rebuild() const {
    const Embree &low = embrees_[0], &medium = embrees_[1];
    return spread(low.total_ms).median <= spread(medium.total_ms).median ? low : medium;
}

Spread ratio(const std::vector<double>& base, const std::vector<double>& work) {
    std::vector<double> ratios;
    for (size_t i = 0; i < work.size(); ++i) ratios.push_back(base[i] / work[i]);
    return spread(ratios);
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
    const Embree &best = best_rebuild(), &refit = embrees_[2];
    const Spread total = spread(c.total_ms);
    const Spread against = ratio(best.total_ms, c.total_ms);
    metrics.update({{"ms_total", total.median},
                    {"ms_total_low", total.low},
                    {"ms_total_high", total.high},
                    {"ms_bound", spread(c.bound_ms).median},
                    {"ms_build", spread(c.build_ms).median},
                    {"ms_traverse", spread(c.traverse_ms).median},
                    {"embree_build", name_of(best.build)},
                    {"embree_packet", best.mode.width},
                    {"embree_build_ms", spread(best.build_ms).median},
                    {"embree_trace_ms", spread(best.trace_ms).median},
                    {"embree_refit_ms", spread(refit.build_ms).median},
                    {"embree_refit_trace_ms", spread(refit.trace_ms).median},
                    {"ratio_embree", against.median},
                    {"ratio_embree_low", against.low},
                    {"ratio_embree_high", against.high},
                    {"ratio_embree_refit", ratio(refit.total_ms, c.total_ms).median},
                    {"rounds", c.total_ms.size()}});
}

nlohmann::json RowRun::metrics(const Contender& c) const {
    nlohmann::json metrics = {{"tests_per_ray", c.work.tests_per_ray},
                              {"pairs_peak", c.work.peak_pairs},
                              {"bytes_peak", c.tracer->bytes()},
                              {"launches", c.work.launches},
                              {"embree_same_distance", c.differences.same_distance},
                              {"embree_edge", c.differences.edge},
                              {"embree_grazing", c.differences.grazing},
                              {"embree_other", c.differences.other},
                              {"mismatches", c.mismatches},
                              {"hits_checksum", c.hits_checksum}};
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
