#include "queries/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "stability/traced_scene.hpp"
#include "timing.hpp"
#include "upload.hpp"

namespace bench::queries {
namespace {

using stability::AllHits;
using stability::Scene;
using stability::TracedScene;

constexpr std::array<const char*, 4> kNames = {"closest", "any", "count", "all"};
constexpr size_t kCheckedRays = 512;

bool is_same(const rsh_hit& a, const rsh_hit& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

Scene some_rays_of(const Scene& scene, size_t step) {
    Scene some = scene;
    some.rays.rays.clear();
    for (size_t i = 0; i < scene.rays.rays.size(); i += step)
        some.rays.rays.push_back(scene.rays.rays[i]);
    some.rays.width = uint32_t(some.rays.rays.size());
    some.rays.height = 1;
    return some;
}

// Of these answers to count and to all, those that differ from brute force's or from each other.
size_t wrong_answers(const Device& device, const Scene& scene, const AllHits& all,
                     const std::vector<cl_uint>& counts) {
    const size_t step = std::max<size_t>(counts.size() / kCheckedRays, 1);
    Column brute;
    brute.engine = RSH_ENGINE_BRUTE_FORCE;
    const AllHits right =
        TracedScene(device, some_rays_of(scene, step)).all(brute, true, 4 * kCheckedRays);
    size_t wrong = 0;
    for (size_t i = 0; i < counts.size(); ++i) wrong += counts[i] != all.count(i);
    for (size_t k = 0; k + 1 < right.offsets.size(); ++k) {
        const size_t i = k * step, count = right.count(k);
        wrong += all.count(i) != count ||
                 !std::equal(all.of(i), all.of(i) + count, right.of(k), is_same);
    }
    return wrong;
}

struct Times {
    std::vector<double> total, traverse, total_ratio, traverse_ratio;  // over closest
};

}  // namespace

std::string case_name(const std::string& scene, const Column& column) {
    return fmt::format("queries/rays:{}/engine:{}/bound:{}", scene, column.engine_name,
                       column.bound_name);
}

Case measure(const Device& device, const std::string& name, const Scene& scene,
             const Column& column, const Amount& amount) {
    const TracedScene on_device(device, scene);
    const AllHits all = on_device.all(column, false, 4 * scene.rays.rays.size());
    Case made = {case_name(name, column),
                 {{"rays", name},
                  {"triangles", scene.mesh.triangle_count()},
                  {"engine", column.engine_name},
                  {"bound", column.bound_name}},
                 {{"ray_count", scene.rays.rays.size()},
                  {"hits_per_ray", double(all.hits.size()) / double(scene.rays.rays.size())}}};
    const size_t wrong = wrong_answers(device, scene, all, on_device.counts(column, false));
    made.metrics["wrong"] = wrong;
    made.ok = wrong == 0;
    if (!made.ok) return made;

    const cl::Buffer rays = upload(device, scene.rays.rays);
    std::vector<RshTracer> tracers;
    for (cl_uint query = 0; query < kNames.size(); ++query)
        tracers.push_back(on_device.tracer(column, false, query, all.hits.size()));
    std::array<Times, kNames.size()> times;
    for (size_t round = 0; round <= amount.rounds; ++round)
        for (size_t q = 0; q < tracers.size(); ++q) {
            const FrameTimes taken = tracers[q].trace(rays);
            if (round == 0) continue;
            times[q].total.push_back(taken.total);
            times[q].traverse.push_back(taken.traverse);
            times[q].total_ratio.push_back(taken.total / times[0].total.back());
            times[q].traverse_ratio.push_back(taken.traverse / times[0].traverse.back());
        }
    for (size_t q = 0; q < kNames.size(); ++q) {
        const std::string query = kNames[q];
        made.metrics["ms_" + query] = spread(times[q].total).median;
        made.metrics["ms_traverse_" + query] = spread(times[q].traverse).median;
        if (q == RSH_QUERY_CLOSEST) continue;
        made.metrics["ratio_" + query] = spread(times[q].total_ratio).median;
        made.metrics["ratio_traverse_" + query] = spread(times[q].traverse_ratio).median;
    }
    return made;
}

std::string as_text(const Case& c) {
    const auto& m = c.metrics;
    if (!c.ok) return fmt::format("{}: {} wrong answers\n", c.name, m["wrong"].get<size_t>());
    const auto number = [&](const std::string& key) { return m[key].get<double>(); };
    std::string text = fmt::format("{}: {:.2f} hits per ray; closest {:.1f} ms", c.name,
                                   number("hits_per_ray"), number("ms_closest"));
    for (const std::string query : {"any", "count", "all"})
        text += fmt::format(", {} {:.2f} times (traversal {:.2f})", query,
                            number("ratio_" + query), number("ratio_traverse_" + query));
    return text + '\n';
}

}  // namespace bench::queries
