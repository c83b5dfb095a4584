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
// Products that underflow in float, flushed to zero or not, and sums of a few of them.
constexpr double kUnderflow = 0x1p-123;
// The same in the few differences and products of a lateral coordinate.
constexpr double kFlushed = 0x1p-124;

struct Volumes {
    double w[3];      // of the edge opposite to corner i
    double bound[3];  // of a float routine's error
};

// The larger component of two edges; triangles below 2^-20 are computed with as if they were of
// unit size.
double underflow_of(const Double3 (&p)[3]) {
    const double size = std::max(max_norm(p[1] - p[0]), max_norm(p[2] - p[0]));
    return size < 0x1p-20 ? kUnderflow * size * size : kUnderflow;
}

double volume_bound(Double3 d, Double3 p, Double3 q, double underflow) {
    const double scale = max_norm(d);
    const double ep = kShearUlps * kUnit * max_norm(p) + kFlushed;
    const double eq = kShearUlps * kUnit * max_norm(q) + kFlushed;
    const double lp = max_norm(cross(d, p)) / scale, lq = max_norm(cross(d, q)) / scale;
    return scale * (2 * (ep * lq + eq * lp + ep * eq) + 8 * kUnit * lp * lq + underflow);
}

Volumes volumes_of(Double3 d, const Double3 (&p)[3]) {
    Volumes volumes;
    const double underflow = underflow_of(p);
    for (int i = 0; i < 3; ++i) {
        const Double3 b = p[(i + 1) % 3], c = p[(i + 2) % 3];
        volumes.w[i] = dot(d, cross(b, c));
        volumes.bound[i] = volume_bound(d, b, c, underflow);
    }
    return volumes;
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
void locate_along(int axis, Double3 d, const Double3 (&p)[3], const Volumes& volumes,
                  Candidate* out) {
    const double sum = sum_of(volumes.w);
    double z[3], weighted = 0;
    for (int i = 0; i < 3; ++i) {
        z[i] = component(p[i], axis) / component(d, axis);
        weighted += volumes.w[i] * z[i];
    }
    const double pad =
        kDepthUlps * kUnit * std::max({std::fabs(z[0]), std::fabs(z[1]), std::fabs(z[2])}) +
        0x1p-140;
    const auto [least, greatest] = std::minmax({z[0], z[1], z[2]});
    out->t = sum != 0 ? std::clamp(weighted / sum, least, greatest) : least;
    double low = least - pad, high = greatest + pad;
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
void locate(Double3 d, const Double3 (&p)[3], const Volumes& volumes, Candidate* out) {
    out->t_low = std::numeric_limits<double>::infinity();
    out->t_high = -out->t_low;
    for (int axis = 2; axis >= 0; --axis)
        if (std::fabs(component(d, axis)) == max_norm(d))
            locate_along(axis, d, p, volumes, out);
    out->uv_error = 1;
    if (!is_known(volumes)) return;
    const double sum = sum_of(volumes.w);
    out->u = volumes.w[1] / sum;
    out->v = volumes.w[2] / sum;
    out->uv_error = 2 * sum_of(volumes.bound) / std::fabs(sum) + 16 * kUnit;
}

}  // namespace

Candidate intersect(const rsh_ray& ray, const Corners& c) {
    Candidate result;
    if (!test::is_active(ray) || !can_be_hit(c)) return result;
    const Double3 o(test::origin(ray)), d(test::direction(ray));
    const Double3 p[3] = {Double3(c[0]) - o, Double3(c[1]) - o, Double3(c[2]) - o};
    const Volumes volumes = volumes_of(d, p);
    if (of_two_signs(volumes)) return result;

    locate(d, p, volumes, &result);
    const double tmin = std::max(ray.origin_tmin.s[3], 0.0f), tmax = ray.direction_tmax.s[3];
    result.possible = result.t_high >= tmin && result.t_low <= tmax;
    result.certain = all_of_one_sign(volumes) && result.t_low >= tmin && result.t_high <= tmax;
    result.exact = result.t >= tmin && result.t <= tmax && exactly_inside(ray, c, volumes);
    return result;
}

}  // namespace oracle
