#include "stability/aim.hpp"

namespace bench::stability {
namespace {

using test::Float3;

template <class Make>
test::Rays square(uint32_t side, Make make) {
    test::Rays rays = {{}, side, side};
    for (uint32_t i = 0; i < side * side; ++i) rays.rays.push_back(make());
    return rays;
}

}  // namespace

test::Rays rays_at_triangles(test::Random& random, const test::Mesh& mesh, uint32_t side) {
    return square(side, [&] {
        test::Corners c;
        while (!mesh.corners(random.below(mesh.triangle_count()), &c)) continue;
        float u = random.unit(), v = random.unit();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Float3 at = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
        const Float3 from = at + 4.0f * random.direction();
        return test::make_ray(from, at - from);
    });
}

test::Rays rays_from(test::Random& random, const test::Mesh& mesh, uint32_t side, float reach) {
    return square(side, [&] {
        const Float3 from = random.in_cube(reach);
        return test::make_ray(from, test::point_on_edge(random, mesh) - from);
    });
}

}  // namespace bench::stability
