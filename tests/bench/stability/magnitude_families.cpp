// magnitude_families.cpp - the same scene near the limits of what a float holds.
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

Scene small_scales(Random& random, Extent e) {
    return placed(random, e, magnitude(random, -18, -1));
}
Scene large_scales(Random& random, Extent e) {
    return placed(random, e, magnitude(random, 1, 18));
}
Scene offsets(Random& random, Extent e) {
    const float far = magnitude(random, 3, 6);
    return placed(random, e, 1, far * random.direction());
}

// Each ray its own length; t counts in it.
Scene direction_lengths(Random& random, Extent e) {
    Scene scene = {test::random_soup(random, e.triangles),
                   test::random_rays(random, e.side, e.side)};
    for (rsh_ray& ray : scene.rays.rays)
        ray = test::make_ray(test::origin(ray),
                             magnitude(random, -30, 30) * test::direction(ray));
    return scene;
}

}  // namespace

std::vector<Family> magnitude_families() {
    return {{"small_scales", Kind::kRandom, small_scales},
            {"large_scales", Kind::kRandom, large_scales},
            {"offsets", Kind::kRandom, offsets},
            {"direction_lengths", Kind::kRandom, direction_lengths}};
}

}  // namespace bench::stability
