// bundle_families.cpp - rays that no cone and no box bounds well, and rays that are none.
#include "stability/family.hpp"

namespace bench::stability {
namespace {

using test::Float3;
using test::Random;
using test::Rays;

Scene at_soup(Random& random, Extent e, Rays rays) {
    return {test::random_soup(random, e.triangles), std::move(rays)};
}

Scene pinhole(Random& random, Extent e) {
    return at_soup(random, e, test::pinhole_rays(e.side, e.side));
}
Scene reflected(Random& random, Extent e) {
    return at_soup(random, e, test::reflected_rays(random, e.side, e.side));
}
Scene fan_90(Random& random, Extent e) {
    return at_soup(random, e, test::fan_rays(e.side, e.side, 90));
}
Scene fan_185(Random& random, Extent e) {
    return at_soup(random, e, test::fan_rays(e.side, e.side, 185));
}
Scene fan_between(Random& random, Extent e) {
    const float degrees = random.between(90, 185);
    return at_soup(random, e, test::fan_rays(e.side, e.side, degrees));
}
Scene antiparallel(Random& random, Extent e) {
    return at_soup(random, e, test::antiparallel_rays(random, e.side, e.side));
}
Scene identical_rays(Random& random, Extent e) {
    return at_soup(random, e, test::coincident_rays(e.side, e.side));
}
Scene invalid_rays(Random& random, Extent e) {
    return at_soup(random, e, test::invalid_rays(random, e.side, e.side));
}

// The light is a corner of a triangle, on an edge or within it.
Scene converging(Random& random, Extent e) {
    const test::Mesh mesh = test::random_soup(random, e.triangles);
    test::Corners c;
    mesh.corners(random.below(mesh.triangle_count()), &c);
    const float u = random.chance(0.7f) ? random.unit() : 0.0f;
    const float v = random.chance(0.5f) ? random.unit() : 0.0f;
    const Float3 light = c[0] + u * (1 - v) * (c[1] - c[0]) + v * (c[2] - c[0]);
    return {mesh, test::converging_rays(random, e.side, e.side, light), true};
}

}  // namespace

std::vector<Family> bundle_families() {
    return {{"pinhole", Kind::kRandom, pinhole},
            {"reflected", Kind::kRandom, reflected},
            {"fan_90", Kind::kRandom, fan_90},
            {"fan_185", Kind::kRandom, fan_185},
            {"fan_between", Kind::kRandom, fan_between},
            {"antiparallel", Kind::kRandom, antiparallel},
            {"identical_rays", Kind::kRandom, identical_rays},
            {"invalid_rays", Kind::kRandom, invalid_rays},
            {"converging", Kind::kAimed, converging}};
}

}  // namespace bench::stability
