// frame_contender.cpp - the metrics of a case, in the order in which they become known.
#include "frame/frame_contender.hpp"

#include <utility>

#include "frame/checksum.hpp"
#include "timing.hpp"

namespace bench {

bool FrameContender::is_done() const {
    constexpr double kSlowMs = 1500;
    return is_wrong || !why_left_out.empty() ||
           (!total_ms.empty() && total_ms.back() > kSlowMs);
}

// A refit is checked on bounds that were made of another moment.
void FrameContender::check(SceneOnDevice& scene, const RayMaker& rays, bool is_shadow,
                           const FramePeers& peers) {
    tracer->allocate();
    if (column.is_refit) {
        scene.move(kEarlierMoment);
        tracer->trace(rays.buffer());
        scene.move(kCheckedMoment);
    }
    tracer->trace(rays.buffer());
    const size_t mismatches = tracer->mismatches();
    is_wrong = mismatches > 0;
    if (is_shadow) {
        const auto ours = tracer->occlusion();
        hits_checksum = checksum(ours);
        for (const auto& peer : peers) peer->compare_occlusion(ours, metrics);
    } else {
        const auto ours = tracer->hits();
        hits_checksum = checksum(ours);
        for (const auto& peer : peers) peer->compare(ours, metrics);
    }
    metrics.update({{"mismatches", mismatches},
                    {"hits_checksum", hits_checksum},
                    {"bytes_peak", tracer->bytes()}});
}

void FrameContender::count(const RayMaker& rays, size_t active_rays) {
    const FrameWork work = tracer->count(rays.buffer(), active_rays);
    metrics.update({{"tests_per_ray", work.tests_per_ray},
                    {"pairs_peak", work.peak_pairs},
                    {"launches", work.launches}});
    constexpr std::pair<int, const char*> kStages[] = {
        {RSH_STAGE_BOUND, "events_ms_bound"},         {RSH_STAGE_BUILD, "events_ms_build"},
        {RSH_STAGE_TEST, "events_ms_test"},           {RSH_STAGE_REDUCE, "events_ms_reduce"},
        {RSH_STAGE_INTERSECT, "events_ms_intersect"}, {RSH_STAGE_OTHER, "events_ms_other"}};
    for (const auto& [stage, name] : kStages) metrics[name] = work.stage_ms[size_t(stage)];
}

void FrameContender::time(const RayMaker& rays) {
    const FrameTimes times = tracer->trace(rays.buffer());
    total_ms.push_back(times.total);
    bound_ms.push_back(times.bound);
    build_ms.push_back(times.build);
    traverse_ms.push_back(times.traverse);
}

double FrameContender::put_times(const FramePeers& peers) {
    const Spread total = spread(total_ms);
    metrics.update({{"ms_total", total.median},
                    {"ms_total_low", total.low},
                    {"ms_total_high", total.high},
                    {"ms_bound", spread(bound_ms).median},
                    {"ms_build", spread(build_ms).median},
                    {"ms_traverse", spread(traverse_ms).median},
                    {"rounds", total_ms.size()}});
    for (const auto& peer : peers) peer->put_times(total_ms, metrics);
    return total.median;
}

}  // namespace bench
