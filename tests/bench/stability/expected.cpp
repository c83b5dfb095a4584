#include "stability/expected.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "oracle/crossings/judge_crossings.hpp"
#include "oracle/lattice.hpp"
#include "oracle/leaving/inside.hpp"

namespace bench::stability {
namespace {

using test::Corners;
using test::Float3;

struct LessBits {
    bool operator()(const Corners& a, const Corners& b) const {
        return std::memcmp(&a, &b, sizeof a) < 0;
    }
};

std::vector<uint32_t> find_twins(const test::Mesh& mesh) {
    std::map<Corners, uint32_t, LessBits> first;
    std::vector<uint32_t> twins(mesh.triangle_count());
    for (uint32_t i = 0; i < twins.size(); ++i) {
        Corners corners;
        const bool is_valid = mesh.corners(i, &corners);
        if (is_valid)
            std::sort(corners.begin(), corners.end(), [](const Float3& a, const Float3& b) {
                return std::memcmp(&a, &b, sizeof a) < 0;
            });
        twins[i] = is_valid ? first.emplace(corners, i).first->second : i;
    }
    return twins;
}

// What leaks out of a closed mesh, was missed, wherever it went through.
void forbid_leak(oracle::Answer& answer) {
    answer.certain_by = std::min(answer.certain_by, double(std::numeric_limits<float>::max()));
}

// Unless the way out may lie before tmin, within rounding.
void forbid_leaks_from_inside(const Scene& scene, Expected& expected) {
    for (size_t k = 0; k < expected.rays.size(); ++k) {
        const rsh_ray& ray = scene.rays.rays[expected.rays[k]];
        oracle::Answer& answer = expected.answers[k];
        if (!test::is_active(ray) || !std::isinf(ray.direction_tmax.s[3])) continue;
        test::Corners exit;
        if (answer.primitive != RSH_NO_HIT && scene.mesh.corners(answer.primitive, &exit) &&
            oracle::intersect(ray, exit).t_low < ray.origin_tmin.s[3])
            continue;
        if (oracle::is_inside(scene.mesh, test::origin(ray))) forbid_leak(answer);
    }
}

}  // namespace

Expected expected_answers(const Scene& scene, Kind kind, size_t most,
                          oracle::Denormals denormals) {
    Expected expected;
    expected.denormals = denormals;
    const std::vector<rsh_ray>& all = scene.rays.rays;
    const std::vector<uint32_t>& all_skip = scene.rays.skip;
    const size_t step = std::max<size_t>(all.size() / std::max<size_t>(most, 1), 1);
    std::vector<rsh_ray> rays;
    std::vector<uint32_t> skip;
    for (size_t i = 0; i < all.size(); i += step) {
        expected.rays.push_back(i);
        rays.push_back(all[i]);
        if (!all_skip.empty()) skip.push_back(all_skip[i]);
    }
    expected.is_exact = kind == Kind::kLattice;
    expected.answers = expected.is_exact ? oracle::lattice_closest(scene.mesh, rays, skip)
                                         : oracle::closest(scene.mesh, rays, skip, denormals);
    expected.crossings = expected.is_exact
                             ? oracle::lattice_crossings(scene.mesh, rays, skip)
                             : oracle::crossings(scene.mesh, rays, skip, denormals);
    if (kind == Kind::kClosed || kind == Kind::kThrough)
        expected.is_inside = kind == Kind::kClosed;
    if (kind == Kind::kClosed)
        for (oracle::Answer& answer : expected.answers) forbid_leak(answer);
    if (kind == Kind::kSpawned) forbid_leaks_from_inside(scene, expected);
    for (size_t k = 0; k < rays.size(); ++k) {
        if (test::is_active(rays[k])) expected.decisions += scene.mesh.triangle_count();
        expected.undecided += expected.answers[k].undecided;
        expected.undecided_crossings += oracle::count_undecided(expected.crossings[k]);
    }
    expected.twins = find_twins(scene.mesh);
    return expected;
}

}  // namespace bench::stability
