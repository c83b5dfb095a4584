#include "parity/parity_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench::parity {
namespace {

using test::Float3;
using test::Mesh;
using test::Random;

struct Box {
    Float3 low, high;
};

// A twentieth larger on each side than the mesh.
Box box_around(const Mesh& mesh) {
    const float most = std::numeric_limits<float>::max();
    Box box = {{most, most, most}, {-most, -most, -most}};
    for (const Float3& v : mesh.vertices) {
        box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y),
                   std::min(box.low.z, v.z)};
        box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y),
                    std::max(box.high.z, v.z)};
    }
    const Float3 more = 0.05f * (box.high - box.low);
    return {box.low - more, box.high + more};
}

float& component(Float3& v, uint32_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

Float3 anywhere_in(Random& random, const Box& box) {
    const auto between = [&](float low, float high) { return random.between(low, high); };
    return {between(box.low.x, box.high.x), between(box.low.y, box.high.y),
            between(box.low.z, box.high.z)};
}

uint32_t steepest_axis(const test::Corners& c) {
    const Float3 n = cross(c[1] - c[0], c[2] - c[0]);
    const float x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
    return x > y && x > z ? 0 : y > z ? 1 : 2;
}

// Through `through`, to the last bit; mostly away from the triangle rather than along it.
rsh_ray along_axis(Random& random, const Box& box, const test::Corners& c, Float3 through) {
    const uint32_t axis = random.chance(0.75f) ? steepest_axis(c) : random.below(3);
    Float3 from = through, in_box = anywhere_in(random, box), direction;
    const float at = component(from, axis);
    component(from, axis) = component(in_box, axis);
    component(direction, axis) = component(from, axis) < at ? 1.0f : -1.0f;
    return test::make_ray(from, direction);
}

// From 1 to 128 lengths before the first corner of an edge, to it or away from it.
rsh_ray along_edge(Random& random, const test::Corners& c) {
    const uint32_t k = random.below(3);
    const Float3 edge = c[(k + 1) % 3] - c[k];
    if (max_norm(edge) == 0) return test::make_ray(c[k], {0, 0, 1});
    const auto steps = float(1u << random.below(8));
    return test::make_ray(c[k] - steps * edge, random.chance(0.5f) ? edge : -1.0f * edge);
}

rsh_ray chosen(Random& random, const Mesh& mesh, const Box& box) {
    test::Corners c;
    mesh.corners(random.below(mesh.triangle_count()), &c);
    switch (random.below(3)) {
        case 0:
            return along_axis(random, box, c, c[random.below(3)]);
        case 1:
            return along_axis(random, box, c, 0.5f * (c[0] + c[1 + random.below(2)]));
        default:
            return along_edge(random, c);
    }
}

}  // namespace

const char* name_of(Points points) {
    return points == Points::kRandom ? "random" : "chosen";
}

test::Rays rays_from(Random& random, const Mesh& mesh, Points points, uint32_t count) {
    const Box box = box_around(mesh);
    test::Rays rays{{}, count, 1};
    for (uint32_t i = 0; i < count; ++i)
        rays.rays.push_back(points == Points::kChosen
                                ? chosen(random, mesh, box)
                                : test::make_ray(anywhere_in(random, box), random.direction()));
    return rays;
}

}  // namespace bench::parity
