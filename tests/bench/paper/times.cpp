#include "paper/times.hpp"

#include <algorithm>
#include <numeric>

#include "timing.hpp"

namespace bench::paper {
namespace {

using nlohmann::json;

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           double(std::max<size_t>(values.size(), 1));
}

// The median where nothing moves, else the animation's mean.
double typical(const Row& row, const std::vector<double>& values) {
    return row.scene.moves ? mean(values) : spread(values).median;
}

// Milliseconds of these stages in a frame.
double stage(const Row& row, const Times& times, std::initializer_list<int> stages) {
    std::vector<double> ms;
    for (const FrameWork& work : times.works) {
        ms.push_back(0);
        for (const int i : stages) ms.back() += work.stage_ms[size_t(i)];
    }
    return typical(row, ms);
}

// Shares of the frames that were counted; `other` is all that has no name here: the camera's rays,
// spawning, clears, and waits of the host.
json shares(const Row& row, const Times& times) {
    std::vector<double> frame_ms;
    for (const FrameWork& work : times.works) frame_ms.push_back(work.frame_ms);
    const double whole = typical(row, frame_ms);
    json found = {
        {"share_build", stage(row, times, {RSH_STAGE_BOUND, RSH_STAGE_BUILD}) / whole},
        {"share_tests", stage(row, times, {RSH_STAGE_TEST}) / whole},
        {"share_reduction", stage(row, times, {RSH_STAGE_REDUCE}) / whole},
        {"share_intersect", stage(row, times, {RSH_STAGE_INTERSECT}) / whole},
        {"share_shade", stage(row, times, {RSH_STAGE_SHADE}) / whole}};
    double named = 0;
    for (const json& share : found) named += share.get<double>();
    found["share_other"] = 1 - named;
    return found;
}

json counts(const Times& times) {
    double node_tests = 0, ray_tests = 0, batches = 0, rays = 0;
    cl_ulong pairs = 0;
    const double n = double(times.works.size());
    for (const FrameWork& work : times.works) {
        const rsh_statistics& s = work.statistics;
        node_tests += double(s.node_tests) / n;
        ray_tests += double(s.ray_tests) / n;
        batches = std::max(batches, work.batches());
        pairs = std::max(pairs, s.peak_pairs);
        for (size_t i = 1; i <= RSH_MAX_LEVELS; ++i) rays += double(s.active_rays[i]) / n;
        for (const cl_ulong shadow : s.shadow_rays) rays += double(shadow) / n;
    }
    return {{"batches", batches},
            {"pairs_peak", pairs},
            {"node_tests", node_tests},
            {"ray_tests", ray_tests},
            {"rays", rays}};
}

// Of the first frame, with the engine paper_faithful: the pairs of triangles and nodes by level, [0] those
// of triangles and rays.
json pairs_by_level(const Times& times) {
    const cl_ulong* found = times.works.front().statistics.pairs_tested;
    std::vector<cl_ulong> pairs(found, found + RSH_MAX_LEVELS + 1);
    while (!pairs.empty() && pairs.back() == 0) pairs.pop_back();
    return pairs;
}

}  // namespace

json times_of(const Row& row, const Times& times) {
    json found = {{"ms", typical(row, times.ms)},
                  {"ms_low", spread(times.ms).low},
                  {"ms_high", spread(times.ms).high},
                  {"frame_ms", typical(row, times.frame_ms)},
                  {"frame_ms_low", spread(times.frame_ms).low},
                  {"frame_ms_high", spread(times.frame_ms).high},
                  {"ms_bound", stage(row, times, {RSH_STAGE_BOUND})},
                  {"ms_build", stage(row, times, {RSH_STAGE_BUILD})},
                  {"ms_tests", stage(row, times, {RSH_STAGE_TEST})},
                  {"ms_reduction", stage(row, times, {RSH_STAGE_REDUCE})},
                  {"ms_intersect", stage(row, times, {RSH_STAGE_INTERSECT})},
                  {"frames", times.ms.size()}};
    found.update(shares(row, times));
    found.update(counts(times));
    const json pairs = pairs_by_level(times);
    if (!pairs.empty()) found["pairs_by_level"] = pairs;
    if (row.paper_ms)
        found.update({{"paper_ms", *row.paper_ms},
                      {"speedup", *row.paper_ms / found["ms"].get<double>()}});
    if (row.scene.moves)
        found.update({{"ms_by_frame", times.ms}, {"frame_ms_by_frame", times.frame_ms}});
    return found;
}

}  // namespace bench::paper
