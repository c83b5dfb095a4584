// magnitude_families.cpp - the same scene near the limits of what a float holds.
#include <algorithm>
#include <limits>

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
template <class Length>
Scene with_lengths(Random& random, Extent e, Length length, float size = 1) {
    Scene scene = {test::scaled(test::random_soup(random, e.triangles), size),
                   test::random_rays(random, e.side, e.side)};
    for (rsh_ray& ray : scene.rays.rays)
        ray = test::make_ray(size * test::origin(ray), length() * test::direction(ray));
    return scene;
}

Scene direction_lengths(Random& random, Extent e) {
    return with_lengths(random, e, [&] { return magnitude(random, -38, 38); });
}

// From denormals to the largest float, where t is beyond floats, or a denormal of few bits.
Scene direction_limits(Random& random, Extent e) {
    const auto length = [&] {
        return std::exp2(random.chance(0.5f) ? random.between(-135, -120)
                                             : random.between(120, 128));
    };
    return with_lengths(random, e, length, std::exp2(random.between(-16, 0)));
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

float denormal(Random& random) {
    return 0x1p-126f * random.between(-1, 1);
}

// Here and there a denormal instead of a coordinate, of a direction's component, tmin or tmax.
Scene denormal_parts(Random& random, Extent e) {
    Scene scene = {test::random_soup(random, e.triangles),
                   test::random_rays(random, e.side, e.side)};
    for (Float3& v : scene.mesh.vertices)
        for (float* x : {&v.x, &v.y, &v.z})
            if (random.chance(0.1f)) *x = denormal(random);
    for (rsh_ray& ray : scene.rays.rays) {
        for (int i = 0; i < 4; ++i)
            if (random.chance(0.1f)) ray.origin_tmin.s[i] = denormal(random);
        if (random.chance(0.3f)) ray.direction_tmax.s[random.below(3)] = denormal(random);
        if (random.chance(0.02f)) ray.direction_tmax.s[3] = 0x1p-127f;
    }
    return scene;
}

// All corners and origins are denormals, and so is t.
Scene denormal_scene(Random& random, Extent e) {
    const auto length = [] { return 1.0f; };
    return with_lengths(random, e, length, 0x1p-128f);
}

// From 4 away, across x, to near one of the corners that are not far away, within the triangle.
rsh_ray ray_at_near_corner(Random& random, const test::Mesh& mesh) {
    test::Corners c;
    mesh.corners(random.below(mesh.triangle_count()), &c);
    while (max_norm(c[0]) > 2) std::rotate(c.begin(), c.begin() + 1, c.end());
    const auto part = [&](Float3 to) {
        const test::Double3 edge = test::Double3(to) - test::Double3(c[0]);
        return double(0.5f * random.unit()) * std::min(1.0, 1 / length(edge)) * edge;
    };
    const Float3 at = c[0] + Float3(part(c[1]) + part(c[2]));
    const Float3 from = at + Float3(0.1f, 4, 4) * random.direction();
    return test::make_ray(from, at - from);
}

// One corner is far away along x, up to the largest float: needles ever thinner. What t errs by is
// small, as rays go across.
Scene far_corners(Random& random, Extent e) {
    test::Mesh mesh = test::random_soup(random, e.triangles);
    for (uint32_t t = 0; t < mesh.triangle_count(); t += 1 + random.below(3)) {
        const float largest = std::numeric_limits<float>::max();
        const float far = random.chance(0.1f) ? largest : std::exp2(random.between(3, 128));
        mesh.vertices[3 * t + random.below(3)].x =
            random.chance(0.5f) ? std::min(far, largest) : -std::min(far, largest);
    }
    Scene scene = {mesh, {{}, e.side, e.side}};
    for (uint32_t i = 0; i < e.side * e.side; ++i)
        scene.rays.rays.push_back(ray_at_near_corner(random, mesh));
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
            {"scale_1e37", Kind::kRandom, at_scale<37>},
            {"offsets", Kind::kRandom, offsets},
            {"direction_lengths", Kind::kRandom, direction_lengths},
            {"direction_limits", Kind::kAimed, direction_limits},
            {"denormal_parts", Kind::kAimed, denormal_parts},
            {"denormal_scene", Kind::kAimed, denormal_scene},
            {"far_corners", Kind::kAimed, far_corners},
            {"corners_from_afar", Kind::kAimed, corners_from_afar}};
}

}  // namespace bench::stability
