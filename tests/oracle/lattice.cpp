// lattice.cpp - the nearest triangle around a ray's line, edges and corners included.
#include "oracle/lattice.hpp"

#include <cmath>

#include "oracle/lattice_numbers.hpp"

namespace oracle {
namespace {

bool is_inside(const LatticeTriangle& t, Int3 o, Int3 d) {
    int above = 0, below = 0;
    for (int k = 0; k < 3; ++k) {
        const int64_t volume =
            dot(d, cross(t.corner[(k + 1) % 3] - o, t.corner[(k + 2) % 3] - o));
        above += volume > 0;
        below += volume < 0;
    }
    return (above == 0) != (below == 0);
}

Answer answer_of(const std::vector<LatticeTriangle>& triangles, const rsh_ray& ray,
                 uint32_t skipped) {
    const Int3 o = lattice_origin(ray);
    const Int3 d = lattice_direction(ray);
    const float tmin = std::fmax(ray.origin_tmin.s[3], 0.0f), tmax = ray.direction_tmax.s[3];
    Answer answer;
    Fraction nearest = {1, 0};
    for (const LatticeTriangle& triangle : triangles) {
        if (triangle.number == skipped || !is_inside(triangle, o, d)) continue;
        const Fraction t = lattice_t(triangle, o, d);
        if (compared(t, tmin) < 0 || compared(t, tmax) > 0 || !is_less(t, nearest)) continue;
        nearest = t;
        answer.primitive = triangle.number;
    }
    if (answer.primitive == RSH_NO_HIT) return answer;
    answer.possible = true;
    answer.t = answer.certain_by = double(nearest.numerator) / double(nearest.denominator);
    return answer;
}

}  // namespace

std::vector<Answer> lattice_closest(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                                    const std::vector<uint32_t>& skip) {
    const std::vector<LatticeTriangle> triangles = lattice_triangles(mesh);
    std::vector<Answer> answers;
    for (size_t i = 0; i < rays.size(); ++i)
        answers.push_back(
            test::is_active(rays[i])
                ? answer_of(triangles, rays[i], skip.empty() ? RSH_NO_HIT : skip[i])
                : Answer());
    return answers;
}

Verdict judge_exact(const Answer& answer, const test::Mesh& mesh, const rsh_ray& ray,
                    const rsh_hit& hit) {
    const bool is_hit = hit.primitive != RSH_NO_HIT;
    const Verdict any = judge_occlusion(answer, is_hit);
    if (any.fault != Fault::kNone || !is_hit) return any;
    const std::string exactly = ", exactly " + std::to_string(answer.t) + " at triangle " +
                                std::to_string(answer.primitive);
    if (hit.t > answer.t) return {Fault::kMissed, "lies behind a certain hit" + exactly};
    if (!(hit.t == answer.t)) return {Fault::kSpurious, "t is wrong" + exactly};
    if (hit.primitive != answer.primitive)
        return {Fault::kWrongTriangle, "is the wrong triangle" + exactly};
    return judge_hit(answer, mesh, ray, hit);
}

}  // namespace oracle
