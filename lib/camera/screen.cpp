#include "camera/screen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rsh {
namespace {

using Vector = std::array<double, 3>;

Vector vector_of(const rsh_float4& v) {
    return {v.s[0], v.s[1], v.s[2]};
}
Vector scaled(const Vector& v, double factor) {
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double sum_of_sizes(const Vector& v) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}
double largest_size(const Vector& v) {
    return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}
rsh_float4 float4_of(const Vector& v, double w) {
    return {{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]),
             static_cast<float>(w)}};
}

// The camera's vectors times one power of two: exact, and far from overflow.
struct Axes {
    Vector forward, right, down;
};

Axes axes_of(const rsh_camera& camera) {
    const Vector forward = vector_of(camera.forward), right = vector_of(camera.right),
                 up = vector_of(camera.up);
    const double size =
        std::max({largest_size(forward), largest_size(right), largest_size(up)});
    int exponent = 0;
    std::frexp(size, &exponent);
    const double scale = std::ldexp(1.0, -exponent);
    return {scaled(forward, scale), scaled(right, scale), scaled(up, -scale)};
}

// Rows of the inverse of (forward, right, down); see camera/types.h.
struct Rows {
    Vector depth, across, down;
};

Rows rows_of(const Axes& axes) {
    const Vector depth = cross(axes.right, axes.down);
    const double inverse = 1.0 / dot(axes.forward, depth);
    return {scaled(depth, inverse), scaled(cross(axes.down, axes.forward), inverse),
            scaled(cross(axes.forward, axes.right), inverse)};
}

// How far a stored direction can lie beside that of its pixel's centre, in units of x and y.
//
// With u = 2^-24, components of the axes below 1 and x, y exact to 8u, a component of
// forward + x right + y down has errors of 16u from x and y and 12u from products and sums; the
// division by the length adds 3u of the component, below 9u; the length itself only scales.
// That is below 2^-18 and, in camera coordinates, turns (1, x, y) into (1 + d, x + a, ...) with
// d <= 2^-18 |depth row|, a <= 2^-18 |across row|, sums of sizes. With d <= 2^-8 the
// quotient is off by 1.01 (a + d) at most; the rest of the factor 2 is for rounding in
// pixels_of().
double padding_of(const Rows& rows, const Vector& row) {
    return std::ldexp(sum_of_sizes(row) + sum_of_sizes(rows.depth), -17);
}

// False: rows so large that rounding blurs the camera, as good as flat; also NaN and infinity.
// With d <= 2^-8, near_depth needs no more room than its 0.99.
bool is_invertible(const Rows& rows) {
    return sum_of_sizes(rows.depth) <= 0x1p10 && padding_of(rows, rows.across) <= 1.0 &&
           padding_of(rows, rows.down) <= 1.0;
}

}  // namespace

void set_camera(screen_setup& screen, const rsh_camera& camera) {
    const Axes axes = axes_of(camera);
    Rows rows = rows_of(axes);
    if (!is_invertible(rows)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        rows.depth = rows.across = rows.down = {nan, nan, nan};
    }
    const float near = camera.eye.s[3], far = camera.forward.s[3];
    screen.eye_near = camera.eye;
    screen.forward_far =
        float4_of(axes.forward, far == 0.0f ? std::numeric_limits<float>::infinity() : far);
    screen.right = float4_of(axes.right, 0.0);
    screen.down = float4_of(axes.down, 0.0);
    screen.depth_row = float4_of(rows.depth, sum_of_sizes(rows.depth));
    screen.across_row = float4_of(rows.across, sum_of_sizes(rows.across));
    screen.down_row = float4_of(rows.down, sum_of_sizes(rows.down));
    screen.across_padding = static_cast<float>(padding_of(rows, rows.across));
    screen.down_padding = static_cast<float>(padding_of(rows, rows.down));
    // A unit direction has depth 1 / |forward + x right + y down|; 0.99 covers rounding.
    const double longest = std::sqrt(dot(axes.forward, axes.forward)) +
                           std::sqrt(dot(axes.right, axes.right)) +
                           std::sqrt(dot(axes.down, axes.down));
    screen.near_depth = static_cast<float>(std::max(near, 0.0f) * 0.99 / longest);
}

}  // namespace rsh
