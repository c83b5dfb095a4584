// bound_families.cpp - rays for which the test of a triangle errs by far more than the distance to
// what bounds it: a bound that is not padded loses their hits.
#include "stability/family.hpp"

namespace bench::stability {
namespace {

using test::Float3;
using test::Mesh;
using test::Random;

float magnitude(Random& random, float low, float high) {
    return std::pow(10.0f, random.between(low, high));
}

float sign(Random& random) {
    return random.chance(0.5f) ? 1.0f : -1.0f;
}

Float3 along(uint32_t axis, float length) {
    return {axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
}

// A right-angled triangle, its long leg along an axis and thus at the side of its box.
struct Long {
    Float3 middle;  // of the long leg
    uint32_t axis;
    float half;  // of its length
    Float3 across;
};

Long long_triangle(Random& random) {
    const uint32_t axis = random.below(3);
    return {random.in_cube(), axis, magnitude(random, 0, 4),
            along((axis + 1) % 3, sign(random) * magnitude(random, -1, 0))};
}

// Starts beside the middle and runs almost along the leg, to a point barely beside it. Where the
// corners are, far ahead and far behind, the slopes' rounding counts for thousands of times as much
// as where the ray meets the leg.
rsh_ray ray_beside(Random& random, const Long& at) {
    const float length = magnitude(random, -3, 0) * sign(random);
    const auto slope = [&] { return length * sign(random) * magnitude(random, -3, 0); };
    const Float3 d = along(at.axis, length) + along((at.axis + 1) % 3, slope()) +
                     along((at.axis + 2) % 3, slope());
    const Float3 beside = (-magnitude(random, -9, -4)) * at.across;
    return test::make_ray(at.middle + beside - d, d);
}

// The same ray for each 4 x 4 of a square: what bounds them, bounds a single ray.
template <class Make>
test::Rays blocks_of_rays(uint32_t side, Make make) {
    const uint32_t blocks = (side + 3) / 4;
    std::vector<rsh_ray> of_block;
    for (uint32_t b = 0; b < blocks * blocks; ++b) of_block.push_back(make());
    test::Rays rays = {{}, side, side};
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x)
            rays.rays.push_back(of_block[y / 4 * blocks + x / 4]);
    return rays;
}

Scene long_legs(Random& random, Extent e) {
    std::vector<Long> all;
    Mesh mesh;
    for (uint32_t i = 0; i < e.triangles; ++i) {
        all.push_back(long_triangle(random));
        const Long& one = all.back();
        const Float3 leg = along(one.axis, one.half);
        mesh.add(one.middle - leg, one.middle + leg, one.middle + leg + one.across);
    }
    return {mesh, blocks_of_rays(e.side, [&] {
                return ray_beside(random, all[random.below(e.triangles)]);
            })};
}

}  // namespace

std::vector<Family> bound_families() {
    return {{"long_legs", Kind::kAimed, long_legs}};
}

}  // namespace bench::stability
