// windings.cpp - a few points at once, a lane each. With a, b, c the unit vectors from the point to
// the corners, half the solid angle is the argument of the complex number
//     1 + a.b + b.c + c.a + i a.(b x c),
// so that arguments are added by a product: only how often that goes round has to be counted. Compiled
// with -fno-trapping-math, for the vectorizer.
#include "oracle/crossings/windings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/clones.hpp"
#include "oracle/on_all_cores.hpp"

namespace oracle {
namespace {

using test::Double3;
using test::Float3;

constexpr int kLanes = 8;
constexpr double kPi = 3.14159265358979323846;

struct Directions {
    double x[kLanes], y[kLanes], z[kLanes];
};

RSH_TEST_CLONES
void point_to_vertices(const std::vector<Float3>& vertices, const Directions& point,
                       Directions* to) {
    for (size_t i = 0; i < vertices.size(); ++i)
        for (int k = 0; k < kLanes; ++k) {
            const double x = vertices[i].x - point.x[k], y = vertices[i].y - point.y[k];
            const double z = vertices[i].z - point.z[k];
            const double length = std::sqrt(x * x + y * y + z * z);
            to[i].x[k] = x / length;
            to[i].y[k] = y / length;
            to[i].z[k] = z / length;
        }
}

// Numbers of modulus 1, as products of many; and how often they went once round.
struct Turning {
    double re[kLanes], im[kLanes], turns[kLanes];
};

// Both arguments in [0, pi] or both in (-pi, 0): else their sum cannot go past pi or -pi.
RSH_TEST_CLONES
void turn(const Directions& a, const Directions& b, const Directions& c, Turning& sum) {
    for (int k = 0; k < kLanes; ++k) {
        const double ab = a.x[k] * b.x[k] + a.y[k] * b.y[k] + a.z[k] * b.z[k];
        const double bc = b.x[k] * c.x[k] + b.y[k] * c.y[k] + b.z[k] * c.z[k];
        const double ca = c.x[k] * a.x[k] + c.y[k] * a.y[k] + c.z[k] * a.z[k];
        const double im = a.x[k] * (b.y[k] * c.z[k] - b.z[k] * c.y[k]) +
                          a.y[k] * (b.z[k] * c.x[k] - b.x[k] * c.z[k]) +
                          a.z[k] * (b.x[k] * c.y[k] - b.y[k] * c.x[k]);
        const double re = 1 + ab + bc + ca;
        const double next_re = sum.re[k] * re - sum.im[k] * im;
        const double next_im = sum.re[k] * im + sum.im[k] * re;
        const double before = sum.im[k] < 0 ? 1 : 0, with = im < 0 ? 1 : 0;
        const double after = next_im < 0 ? 1 : 0;
        sum.turns[k] += (1 - before) * (1 - with) * after - before * with * (1 - after);
        const double length = std::sqrt(next_re * next_re + next_im * next_im);
        sum.re[k] = next_re / length;
        sum.im[k] = next_im / length;
    }
}

// Each turn of half the angle is 4 pi of the whole.
void wind(const test::Mesh& mesh, const std::vector<Float3>& points, size_t first,
          std::vector<Winding>* out) {
    const size_t last = std::min(first + kLanes, points.size());
    Directions point;
    Turning sum;
    for (int k = 0; k < kLanes; ++k) {
        const Float3 at = points[std::min(first + size_t(k), last - 1)];
        point.x[k] = at.x, point.y[k] = at.y, point.z[k] = at.z;
        sum.re[k] = 1, sum.im[k] = sum.turns[k] = 0;
    }
    std::vector<Directions> to(mesh.vertices.size());
    point_to_vertices(mesh.vertices, point, to.data());
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        uint32_t at[3] = {3 * i, 3 * i + 1, 3 * i + 2};
        if (!mesh.indices.empty())
            for (uint32_t& vertex : at) vertex = mesh.indices[vertex];
        turn(to[at[0]], to[at[1]], to[at[2]], sum);
    }
    for (size_t i = first; i < last; ++i) {
        const size_t k = i - first;
        (*out)[i] = {int(sum.turns[k]),
                     std::fabs(std::atan2(sum.im[k], sum.re[k])) / (2 * kPi)};
    }
}

double distance_to_segment(Double3 p, Double3 a, Double3 b) {
    const Double3 along = b - a;
    const double length2 = dot(along, along);
    const double at = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0;
    return length(p - (a + at * along));
}

// Of its plane, where the point lies above the triangle, else of its edges.
double distance_to_triangle(Double3 p, const test::Corners& corners) {
    const Double3 a(corners[0]), b(corners[1]), c(corners[2]);
    const Double3 normal = cross(b - a, c - a);
    const bool is_above = dot(cross(b - a, p - a), normal) > 0 &&
                          dot(cross(c - b, p - b), normal) > 0 &&
                          dot(cross(a - c, p - c), normal) > 0;
    if (is_above) return std::fabs(dot(normalize(normal), p - a));
    return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c),
                     distance_to_segment(p, c, a)});
}

}  // namespace

std::vector<Winding> windings(const test::Mesh& mesh, const std::vector<Float3>& points) {
    std::vector<Winding> all(points.size());
    on_all_cores((points.size() + kLanes - 1) / kLanes,
                 [&](size_t i) { wind(mesh, points, i * kLanes, &all); });
    return all;
}

double distance_to_surface(const test::Mesh& mesh, Float3 point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        test::Corners corners;
        if (mesh.corners(i, &corners))
            nearest = std::min(nearest, distance_to_triangle(Double3(point), corners));
    }
    return nearest;
}

}  // namespace oracle
