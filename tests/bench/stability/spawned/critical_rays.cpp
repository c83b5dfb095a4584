#include "stability/spawned/critical_rays.hpp"

#include <algorithm>
#include <cmath>

namespace bench::stability {
namespace {

using test::Double3;
using test::Float3;
using test::Random;

double critical_sine(Random& random, float index) {
    const double sine = index > 1 ? 1 / double(index) : double(index);
    if (random.chance(0.2f)) return sine;
    const double ulps = std::exp2(double(random.between(0, 14)));
    return std::min(sine * (1 + (random.chance(0.5f) ? ulps : -ulps) * 0x1p-24), 1 - 0x1p-24);
}

Double3 outwards(const test::Corners& c) {
    const Double3 a(c[0]);
    return normalize(cross(Double3(c[1]) - a, Double3(c[2]) - a));
}

rsh_ray critical_ray(Random& random, const test::Corners& c, float index, double size) {
    const bool is_inside = index > 1;
    const Double3 normal = (is_inside ? -1.0 : 1.0) * outwards(c);
    const Double3 tangent = normalize(cross(normal, Double3(random.direction())));
    const double sine = critical_sine(random, index);
    const double cosine = std::sqrt((1 - sine) * (1 + sine));
    const Double3 d = sine * tangent - cosine * normal;
    // A chord of a ball has twice the cosine.
    const double way = size * double(random.between(0.2f, 1.2f)) * (is_inside ? cosine : 1);
    const Double3 eye = test::hard_point(random, c) - way * d;
    return test::make_ray(Float3(eye), Float3(double(random.between(0.5f, 2)) * size * d));
}

}  // namespace

std::vector<float> critical_indices(Random& random, uint32_t count) {
    std::vector<float> indices;
    for (uint32_t i = 0; i < count; ++i) {
        const float index = 1 + std::pow(10.0f, random.between(-4, 0.30103f));
        indices.push_back(random.chance(0.5f) ? index : 1 / index);
    }
    return indices;
}

test::Rays critical_rays(Random& random, const Crowd& crowd, const std::vector<float>& index_of,
                         uint32_t side) {
    test::Rays rays = {{}, side, side};
    for (uint32_t i = 0; i < side * side; ++i) {
        const uint32_t triangle = random.below(crowd.mesh.triangle_count());
        test::Corners corners;
        crowd.mesh.corners(triangle, &corners);
        rays.rays.push_back(critical_ray(random, corners, index_of[triangle],
                                         crowd.places[crowd.body_of[triangle]].scale));
    }
    return rays;
}

}  // namespace bench::stability
