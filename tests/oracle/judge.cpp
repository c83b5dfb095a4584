#include "oracle/judge.hpp"

#include <cmath>

namespace oracle {
namespace {

// A bound of 0 is met by the exact t alone.
double error_of_budget(const Candidate& c, double t) {
    const double error = std::fabs(t - c.t), budget = t > c.t ? c.t_high - c.t : c.t - c.t_low;
    return error == 0 ? 0 : error / budget;
}

}  // namespace

Verdict judge_hit(const Answer& answer, const test::Mesh& mesh, const rsh_ray& ray,
                  const rsh_hit& hit, Denormals denormals) {
    if (hit.primitive == RSH_NO_HIT) {
        if (std::isinf(answer.certain_by)) return {};
        return {Fault::kMissed, "misses a certain hit"};
    }
    test::Corners corners;
    if (hit.primitive >= mesh.triangle_count() || !mesh.corners(hit.primitive, &corners))
        return {Fault::kSpurious, "names no valid triangle"};
    const Candidate c = intersect(ray, corners, denormals);
    if (!c.possible) return {Fault::kSpurious, "cannot hit that triangle"};
    if (!(hit.t >= c.t_low && hit.t <= c.t_high))
        return {Fault::kSpurious, "t is wrong, exactly " + std::to_string(c.t)};
    if (hit.t > answer.certain_by) return {Fault::kMissed, "lies behind a certain hit"};
    if (!(std::fabs(hit.u - c.u) <= c.uv_error && std::fabs(hit.v - c.v) <= c.uv_error))
        return {Fault::kSpurious,
                "u, v are wrong, exactly " + std::to_string(c.u) + ", " + std::to_string(c.v)};
    if (!answer.ambiguous && hit.primitive != answer.primitive)
        return {Fault::kWrongTriangle, "is the wrong triangle"};
    return {Fault::kNone, "", error_of_budget(c, hit.t)};
}

Verdict judge_occlusion(const Answer& answer, bool is_hit) {
    if (is_hit && !answer.possible) return {Fault::kSpurious, "hits nothing"};
    if (!is_hit && !std::isinf(answer.certain_by))
        return {Fault::kMissed, "misses a certain hit"};
    return {};
}

}  // namespace oracle
