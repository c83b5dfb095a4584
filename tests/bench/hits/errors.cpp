#include "hits/errors.hpp"

#include <fmt/format.h>

#include <cstring>

#include "oracle/judge.hpp"

namespace bench::hits {
namespace {

using oracle::Fault;

// Whether the hit is at a triangle that the ray meets, and none in front of it is sure to be met.
bool is_right_triangle(const oracle::Answer& answer, const test::Mesh& mesh, const rsh_ray& ray,
                       uint32_t primitive) {
    test::Corners corners;
    if (primitive >= mesh.triangle_count() || !mesh.corners(primitive, &corners)) return false;
    const oracle::Candidate c = oracle::intersect(ray, corners);
    return c.possible && c.t_low <= answer.certain_by;
}

void add(const stability::Scene& scene, size_t ray, const oracle::Answer& answer,
         const rsh_hit& hit, Errors& errors) {
    const oracle::Verdict verdict =
        oracle::judge_hit(answer, scene.mesh, scene.rays.rays[ray], hit);
    if (verdict.fault == Fault::kNone) return;
    const bool is_near =
        verdict.fault == Fault::kSpurious &&
        is_right_triangle(answer, scene.mesh, scene.rays.rays[ray], hit.primitive);
    errors.missed += verdict.fault == Fault::kMissed;
    errors.inexact += is_near;
    errors.spurious += verdict.fault == Fault::kSpurious && !is_near;
    errors.wrong_triangle += verdict.fault == Fault::kWrongTriangle;
    if (errors.first.empty()) errors.first = fmt::format("ray {} {}", ray, verdict.why);
}

}  // namespace

void Errors::put(nlohmann::json& metrics) const {
    metrics.update({{"rays", rays},
                    {"judged", judged},
                    {"missed", missed},
                    {"spurious", spurious},
                    {"wrong_triangle", wrong_triangle},
                    {"inexact", inexact},
                    {"leaks", leaks}});
    if (!first.empty()) metrics["why"] = first;
}

Errors count_errors(const stability::Scene& scene, const stability::Expected& expected,
                    bool is_closed, const std::vector<rsh_hit>& hits) {
    const std::vector<rsh_ray>& rays = scene.rays.rays;
    Errors errors;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!test::is_active(rays[i])) continue;
        ++errors.rays;
        if (!is_closed || hits[i].primitive != RSH_NO_HIT) continue;
        ++errors.leaks;
        if (errors.first.empty()) errors.first = fmt::format("ray {} leaks", i);
    }
    for (size_t k = 0; k < expected.rays.size(); ++k) {
        const size_t ray = expected.rays[k];
        if (!test::is_active(rays[ray])) continue;
        ++errors.judged;
        add(scene, ray, expected.answers[k], hits[ray], errors);
    }
    return errors;
}

uint64_t count_differing(const std::vector<rsh_ray>& rays, const std::vector<rsh_hit>& a,
                         const std::vector<rsh_hit>& b) {
    uint64_t count = 0;
    for (size_t i = 0; i < rays.size(); ++i)
        count += test::is_active(rays[i]) && std::memcmp(&a[i], &b[i], sizeof a[i]) != 0;
    return count;
}

}  // namespace bench::hits
