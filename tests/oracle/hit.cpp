// hit.cpp - signed volumes in double, exact signs where double cannot tell.
#include "oracle/hit.hpp"

#include <algorithm>
#include <limits>

#include "oracle/exact.hpp"
#include "support/rays.hpp"

namespace oracle {
namespace {

using test::Corners;
using test::Double3;
using test::Float3;

constexpr double kUnit = 0x1p-24;
constexpr double kShearUlps = 16;
constexpr double kDepthUlps = 32;
constexpr double kLargest = std::numeric_limits<float>::max();

// Within these limits nothing is lost; see rsh_traverse in rsh.h.
constexpr double kFarthest = 0x1p126;   // corner, from the origin
constexpr double kThinnest = 0x1p-62;   // area across the ray, of the size squared
constexpr double kShortest = 0x1p-128;  // direction
constexpr double kShortestNormal = 0x1p-126;
constexpr double kLongestNormal = 0x1p126;  // the reciprocal underflows
constexpr double kRounding = 0x1p-20;       // of these limits

struct Volumes {
    double w[3];      // of the edge opposite to corner i
    double bound[3];  // of a float routine's error
};

// A ray, seen from its origin, and the corners of a triangle.
struct Pair {
    Double3 d, p[3];
    double direction;  // largest component
    double size;       // the same of the edges
    double flushed;    // what an operation that underflows may err by
};

Pair pair_of(const rsh_ray& ray, const Corners& c, Denormals denormals) {
    const Double3 o(test::origin(ray));
    Pair pair = {Double3(test::direction(ray)),
                 {Double3(c[0]) - o, Double3(c[1]) - o, Double3(c[2]) - o},
                 0,
                 0,
                 denormals == Denormals::kKept ? 0x1p-150 : 0x1p-126};
    pair.direction = max_norm(pair.d);
    for (int i = 0; i < 3; ++i)
        pair.size = std::max(pair.size, max_norm(pair.p[i] - pair.p[(i + 1) % 3]));
    return pair;
}

// Of the unit that a routine computes a triangle in.
double computed_unit(double size) {
    return size >= 0x1p-20 && size <= 0x1p20 ? 1 : std::max(size, 0x1p-127);
}

double volume_bound(const Pair& pair, int i, int j) {
    const double slope = std::min(2.0, 2 * pair.flushed / pair.direction);
    const double flushed = pair.flushed * (8 + pair.size);
    const auto error = [&](Double3 p) {
        return (kShearUlps * kUnit + slope) * max_norm(p) + flushed;
    };
    const auto lateral = [&](Double3 p) { return max_norm(cross(pair.d, p)) / pair.direction; };
    const double ep = error(pair.p[i]), eq = error(pair.p[j]);
    const double lp = lateral(pair.p[i]), lq = lateral(pair.p[j]);
    const double unit = computed_unit(pair.size);
    return pair.direction * (2 * (ep * lq + eq * lp + ep * eq) + 8 * kUnit * lp * lq +
                             8 * pair.flushed * unit * unit);
}

Volumes volumes_of(const Pair& pair) {
    Volumes volumes;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        volumes.w[i] = dot(pair.d, cross(pair.p[j], pair.p[k]));
        volumes.bound[i] = volume_bound(pair, j, k);
    }
    return volumes;
}

bool is_slim(const Pair& pair, const Volumes& v) {
    double area = 0;
    for (int i = 0; i < 3; ++i) area += std::fabs(v.w[i]) - v.bound[i];
    const double unit = std::max(pair.size, computed_unit(pair.size) * 0x1p-20);
    return !(area >= 2 * kThinnest * unit * unit * pair.direction);
}

bool is_within_limits(const Pair& pair, Denormals denormals) {
    double farthest = 0;
    for (int i = 0; i < 3; ++i) farthest = std::max(farthest, max_norm(pair.p[i]));
    const bool is_kept = denormals == Denormals::kKept;
    const double shortest = is_kept ? kShortest : kShortestNormal;
    const double longest = is_kept ? kLargest : kLongestNormal;
    return farthest <= kFarthest && pair.direction >= shortest * (1 + kRounding) &&
           pair.direction <= longest * (1 - kRounding * !is_kept);
}

bool all_of_one_sign(const Volumes& v) {
    const auto above = [&](int i) { return v.w[i] > v.bound[i]; };
    const auto below = [&](int i) { return v.w[i] < -v.bound[i]; };
    return (above(0) && above(1) && above(2)) || (below(0) && below(1) && below(2));
}

bool of_two_signs(const Volumes& v) {
    bool above = false, below = false;
    for (int i = 0; i < 3; ++i) {
        above |= v.w[i] > v.bound[i];
        below |= v.w[i] < -v.bound[i];
    }
    return above && below;
}

bool exactly_inside(const rsh_ray& ray, const Corners& c, const Volumes& v) {
    int above = 0, below = 0;
    for (int i = 0; i < 3; ++i) {
        // The bound is far coarser than double's own error.
        const int sign = std::fabs(v.w[i]) > v.bound[i]
                             ? (v.w[i] > 0 ? 1 : -1)
                             : side_of_edge(test::origin(ray), test::direction(ray),
                                            c[(i + 1) % 3], c[(i + 2) % 3]);
        above += sign > 0;
        below += sign < 0;
    }
    return (above == 0) != (below == 0);  // all zero: edge-on
}

bool same(Float3 a, Float3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

// Two equal corners: two volumes are 0 or each other's negative in any arithmetic.
bool can_be_hit(const Corners& c) {
    return finite(c[0]) && finite(c[1]) && finite(c[2]) && !same(c[0], c[1]) &&
           !same(c[1], c[2]) && !same(c[2], c[0]);
}

double component(Double3 v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

double sum_of(const double (&x)[3]) {
    return x[0] + x[1] + x[2];
}

// The volumes say more than the depths of the corners.
bool is_known(const Volumes& v) {
    return std::fabs(sum_of(v.w)) > 4 * sum_of(v.bound);
}

// t and its interval by the depths of the corners along one axis.
void locate_along(int axis, const Pair& pair, const Volumes& volumes, Candidate* out) {
    const double sum = sum_of(volumes.w);
    double z[3], weighted = 0;
    for (int i = 0; i < 3; ++i) {
        z[i] = component(pair.p[i], axis) / component(pair.d, axis);
        weighted += volumes.w[i] * z[i];
    }
    const double pad =
        kDepthUlps * kUnit * std::max({std::fabs(z[0]), std::fabs(z[1]), std::fabs(z[2])}) +
        pair.flushed * (16 / pair.direction + 4);
    const auto [least, greatest] = std::minmax({z[0], z[1], z[2]});
    out->t = sum != 0 ? std::clamp(weighted / sum, least, greatest) : least;
    double low = least - pad, high = greatest + pad;
    out->corner_t_low = std::min(out->corner_t_low, low);
    out->corner_t_high = std::max(out->corner_t_high, high);
    if (is_known(volumes)) {
        double error = pad;
        for (int i = 0; i < 3; ++i)
            error += 2 * volumes.bound[i] * std::fabs(z[i] - out->t) / std::fabs(sum);
        low = std::max(low, out->t - error);
        high = std::min(high, out->t + error);
    }
    out->t_low = std::min(out->t_low, low);
    out->t_high = std::max(out->t_high, high);
}

// t, u, v and their intervals; `volumes` may have any sign. Of axes along which the direction is
// equally long, a float routine may take any.
void locate(const Pair& pair, const Volumes& volumes, Candidate* out) {
    out->t_low = out->corner_t_low = std::numeric_limits<double>::infinity();
    out->t_high = out->corner_t_high = -out->t_low;
    for (int axis = 2; axis >= 0; --axis)
        if (std::fabs(component(pair.d, axis)) == max_norm(pair.d))
            locate_along(axis, pair, volumes, out);
    out->uv_error = 1;
    if (!is_known(volumes)) return;
    const double sum = sum_of(volumes.w);
    out->u = volumes.w[1] / sum;
    out->v = volumes.w[2] / sum;
    out->uv_error = 2 * sum_of(volumes.bound) / std::fabs(sum) + 16 * kUnit;
}

}  // namespace

Candidate intersect(const rsh_ray& ray, const Corners& c, Denormals denormals) {
    Candidate result;
    if (!test::is_active(ray) || !can_be_hit(c)) return result;
    const Pair pair = pair_of(ray, c, denormals);
    if (pair.direction <= kShortest * (1 - kRounding)) return result;
    const Volumes volumes = volumes_of(pair);
    if (of_two_signs(volumes)) return result;

    locate(pair, volumes, &result);
    const double tmin = std::max(ray.origin_tmin.s[3], 0.0f);
    const double tmax = std::min(double(ray.direction_tmax.s[3]), kLargest);
    result.is_slim = is_slim(pair, volumes);
    result.possible = result.is_slim
                          ? result.corner_t_high >= tmin && result.corner_t_low <= tmax
                          : result.t_high >= tmin && result.t_low <= tmax;
    result.certain = all_of_one_sign(volumes) && result.t_low >= tmin &&
                     result.t_high <= tmax && !result.is_slim &&
                     is_within_limits(pair, denormals);
    result.exact = result.t >= tmin && result.t <= tmax && exactly_inside(ray, c, volumes);
    return result;
}

}  // namespace oracle
