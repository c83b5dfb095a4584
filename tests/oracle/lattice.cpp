// lattice.cpp - signs and quotients of integers. With the limits of the header a component of a
// corner seen from an origin is below 2^9, one of a normal below 2^19, and both terms of t below
// 2^30 and 2^25, so that fractions are compared within 2^55.
#include "oracle/lattice.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace oracle {
namespace {

using Int3 = test::Vec3<int64_t>;

// numerator / denominator, the latter positive.
struct Fraction {
    int64_t numerator, denominator;
};

bool is_less(Fraction a, Fraction b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
}

// Exact: a float times an integer below 2^25 fits into a double.
int compared(Fraction t, float limit) {
    const double numerator = double(t.numerator), other = double(limit) * double(t.denominator);
    return numerator < other ? -1 : numerator > other;
}

Int3 integers(test::Float3 v, int limit, const char* what) {
    const auto convert = [&](float x) {
        if (!(std::fabs(x) <= float(limit)) || x != std::trunc(x))
            throw std::invalid_argument(std::string(what) + " is " + std::to_string(x) +
                                        ", must be an integer of at most " +
                                        std::to_string(limit));
        return int64_t(x);
    };
    return {convert(v.x), convert(v.y), convert(v.z)};
}

struct Triangle {
    uint32_t number;
    Int3 corner[3];
    Int3 normal;
};

std::vector<Triangle> triangles_of(const test::Mesh& mesh) {
    std::vector<Triangle> made;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        test::Corners corners;
        if (!mesh.corners(i, &corners)) continue;
        Triangle t = {i, {}, {}};
        for (int k = 0; k < 3; ++k)
            t.corner[k] = integers(corners[k], kLatticeReach, "a corner");
        t.normal = cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
        made.push_back(t);
    }
    return made;
}

bool is_inside(const Triangle& t, Int3 o, Int3 d) {
    int above = 0, below = 0;
    for (int k = 0; k < 3; ++k) {
        const int64_t volume =
            dot(d, cross(t.corner[(k + 1) % 3] - o, t.corner[(k + 2) % 3] - o));
        above += volume > 0;
        below += volume < 0;
    }
    return (above == 0) != (below == 0);
}

Answer answer_of(const std::vector<Triangle>& triangles, const rsh_ray& ray, uint32_t skipped) {
    const Int3 o = integers(test::origin(ray), kLatticeReach, "an origin");
    const Int3 d = integers(test::direction(ray), kLatticeDirection, "a direction");
    const float tmin = std::fmax(ray.origin_tmin.s[3], 0.0f), tmax = ray.direction_tmax.s[3];
    Answer answer;
    Fraction nearest = {1, 0};
    for (const Triangle& triangle : triangles) {
        if (triangle.number == skipped || !is_inside(triangle, o, d)) continue;
        Fraction t = {dot(triangle.corner[0] - o, triangle.normal), dot(d, triangle.normal)};
        if (t.denominator < 0) t = {-t.numerator, -t.denominator};
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
    const std::vector<Triangle> triangles = triangles_of(mesh);
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
