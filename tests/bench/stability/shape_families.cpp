// shape_families.cpp - triangles that are thin, flat, twice there or no triangles.
#include <algorithm>

#include "stability/aim.hpp"
#include "stability/family.hpp"

namespace bench::stability {
namespace {

using test::Float3;
using test::Mesh;
using test::Random;

// 10^-least .. 10^-greatest, evenly over the exponents.
float thin(Random& random, float least, float greatest) {
    return std::pow(10.0f, -random.between(least, greatest));
}

Scene soup(Random& random, Extent e) {
    return {test::random_soup(random, e.triangles), test::random_rays(random, e.side, e.side)};
}

template <class MakeThird>
Scene thin_triangles(Random& random, Extent e, MakeThird third) {
    Mesh mesh;
    for (uint32_t i = 0; i < e.triangles; ++i) {
        const Float3 a = random.in_cube(), b = random.in_cube();
        mesh.add(a, b, third(a, b));
    }
    return {mesh, rays_at_triangles(random, mesh, e.side)};
}

// Thin, with the third corner anywhere along the longest edge.
Scene slivers(Random& random, Extent e) {
    return thin_triangles(random, e, [&](Float3 a, Float3 b) {
        return a + random.unit() * (b - a) + thin(random, 1, 7) * random.in_cube();
    });
}

// One edge is short.
Scene needles(Random& random, Extent e) {
    return thin_triangles(
        random, e, [&](Float3 a, Float3) { return a + thin(random, 2, 7) * random.in_cube(); });
}

// One angle is nearly 180 degrees.
Scene caps(Random& random, Extent e) {
    return thin_triangles(random, e, [&](Float3 a, Float3 b) {
        return a + random.between(0.4f, 0.6f) * (b - a) + thin(random, 4, 7) * random.in_cube();
    });
}

// Corners that are equal or on one line, between triangles that are none of that.
Scene zero_area(Random& random, Extent e) {
    Mesh mesh;
    for (uint32_t i = 0; i < e.triangles / 4; ++i) {
        const Float3 a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
        mesh.add(a, a, b);
        mesh.add(a, b, a);
        mesh.add(a, 2.0f * a, 4.0f * a);
        mesh.add(a, b, c);
    }
    return {mesh, rays_at_triangles(random, mesh, e.side)};
}

Scene invalid_triangles(Random& random, Extent e) {
    return {test::degenerate_soup(random, e.triangles / 2),
            test::random_rays(random, e.side, e.side)};
}

Scene sizes_apart(Random& random, Extent e) {
    const Mesh mesh = test::large_next_to_tiny(random, e.triangles);
    return {mesh, rays_at_triangles(random, mesh, e.side)};
}

// About as many triangles as asked for.
Mesh closed_mesh(Random& random, Extent e) {
    const auto rings = uint32_t(std::sqrt(float(e.triangles) / 4));
    return random.chance(0.5f) ? test::sphere(2 * rings, rings)
                               : test::torus(2 * rings, rings, 1.0f, 0.4f);
}

// The torus has its centre outside.
Scene watertight_inside(Random& random, Extent e) {
    const auto rings = uint32_t(std::sqrt(float(e.triangles) / 4));
    const Mesh mesh = test::sphere(2 * rings, rings);
    return {mesh, rays_from(random, mesh, e.side, 0.25f)};
}

Scene watertight_outside(Random& random, Extent e) {
    const Mesh mesh = closed_mesh(random, e);
    return {mesh, test::rays_at_edges(random, mesh, e.side, e.side)};
}

Scene grazing(Random& random, Extent e) {
    const Mesh mesh = test::random_soup(random, e.triangles);
    return {mesh, test::grazing_rays(random, mesh, e.side, e.side)};
}

// With a triangle to skip per ray, the one that it leaves.
Scene leaving(Random& random, Extent e) {
    const Mesh mesh = closed_mesh(random, e);
    return {mesh, test::leaving_rays(random, mesh, e.side, e.side)};
}

// Begun at a triangle that is not skipped: t is 0, give or take its error.
Scene starting(Random& random, Extent e) {
    const Mesh mesh = test::random_soup(random, e.triangles);
    Scene scene = {mesh, rays_at_triangles(random, mesh, e.side)};
    for (rsh_ray& ray : scene.rays.rays)
        ray = test::make_ray(test::origin(ray) + test::direction(ray), random.direction());
    return scene;
}

// Of all copies of a triangle, the first is hit.
Scene turned_copies(Random& random, Extent e) {
    const Mesh once = test::random_soup(random, std::max(e.triangles / 4, 1u));
    const Mesh mesh = test::turned_copies(random, once, e.triangles);
    return {mesh, rays_at_triangles(random, mesh, e.side)};
}

}  // namespace

std::vector<Family> shape_families() {
    return {{"soup", Kind::kRandom, soup},
            {"slivers", Kind::kAimed, slivers},
            {"needles", Kind::kAimed, needles},
            {"caps", Kind::kAimed, caps},
            {"zero_area", Kind::kAimed, zero_area},
            {"invalid_triangles", Kind::kRandom, invalid_triangles},
            {"sizes_apart", Kind::kAimed, sizes_apart},
            {"watertight_inside", Kind::kClosed, watertight_inside},
            {"watertight_outside", Kind::kThrough, watertight_outside},
            {"grazing", Kind::kAimed, grazing},
            {"leaving", Kind::kAimed, leaving},
            {"starting", Kind::kAimed, starting},
            {"turned_copies", Kind::kAimed, turned_copies}};
}

}  // namespace bench::stability
