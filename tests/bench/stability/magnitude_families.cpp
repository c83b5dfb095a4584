// magnitude_families.cpp - the same scene near the limits of what a float holds.
#include <algorithm>

#include "stability/family.hpp"

namespace bench::stability {
namespace {

using test::Float3;
using test::Random;

// 10^low .. 10^high, evenly over the exponents.
float magnitude(Random& random, float low, float high) {
    return std::pow(10.0f, random.between(low, high));
}

Scene placed(Random& random, Extent e, float scale, Float3 offset = {}) {
    return {test::scaled(test::random_soup(random, e.triangles), scale, offset),
            test::scaled(test::random_rays(random, e.side, e.side), scale, offset)};
}

template <int kExponent>
Scene at_scale(Random& random, Extent e) {
    return placed(random, e, std::pow(10.0f, float(kExponent)));
}
Scene offsets(Random& random, Extent e) {
    const float far = magnitude(random, 3, 8);
    return placed(random, e, std::max(1.0f, 1e-4f * far), far * random.direction());
}

// Each ray its own length; t counts in it.
Scene direction_lengths(Random& random, Extent e) {
    Scene scene = {test::random_soup(random, e.triangles),
                   test::random_rays(random, e.side, e.side)};
    for (rsh_ray& ray : scene.rays.rays)
        ray = test::make_ray(test::origin(ray),
                             magnitude(random, -36, 36) * test::direction(ray));
    return scene;
}

// The rays' coordinates, and not the scene's, decide how much room a box must leave.
Scene corners_from_afar(Random& random, Extent e) {
    const test::Mesh mesh = test::square_triangles(random, e.triangles);
    Scene scene = {mesh, {{}, e.side, e.side}};
    while (scene.rays.rays.size() < size_t{e.side} * e.side) {
        const test::Rays row =
            test::rays_from_afar(random, mesh, e.side, magnitude(random, 1, 5));
        scene.rays.rays.insert(scene.rays.rays.end(), row.rays.begin(), row.rays.end());
    }
    return scene;
}

}  // namespace

std::vector<Family> magnitude_families() {
    return {{"scale_1e-30", Kind::kRandom, at_scale<-30>},
            {"scale_1e-20", Kind::kRandom, at_scale<-20>},
            {"scale_1e-10", Kind::kRandom, at_scale<-10>},
            {"scale_1e10", Kind::kRandom, at_scale<10>},
            {"scale_1e20", Kind::kRandom, at_scale<20>},
            {"scale_1e30", Kind::kRandom, at_scale<30>},
            {"offsets", Kind::kRandom, offsets},
            {"direction_lengths", Kind::kRandom, direction_lengths},
            {"corners_from_afar", Kind::kAimed, corners_from_afar}};
}

}  // namespace bench::stability
