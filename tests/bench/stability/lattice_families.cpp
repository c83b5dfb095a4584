// lattice_families.cpp - scenes of small integers, for which oracle/lattice.hpp knows the only right
// answer: right-angled triangles along two axes with legs of 1, 2, 4 or 8, directions of 0, 1 and 2.
#include <algorithm>
#include <limits>

#include "stability/family.hpp"

namespace bench::stability {
namespace {

using test::Float3;
using test::Mesh;
using test::Random;

constexpr int kHalf = 8;  // of the cube that holds the first corners

float& component(Float3& v, uint32_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

float sign(Random& random) {
    return random.chance(0.5f) ? 1.0f : -1.0f;
}

Float3 lattice_point(Random& random, int half = kHalf) {
    const auto one = [&] { return float(int(random.below(uint32_t(2 * half + 1))) - half); };
    return {one(), one(), one()};
}

test::Corners right_triangle(Random& random) {
    const Float3 at = lattice_point(random);
    const uint32_t axis = random.below(3);
    Float3 a = at, b = at;
    component(a, axis) += sign(random) * float(1u << random.below(4));
    component(b, (axis + 1) % 3) += sign(random) * float(1u << random.below(4));
    return {at, a, b};
}

Mesh right_triangles(Random& random, uint32_t count) {
    Mesh mesh;
    for (uint32_t i = 0; i < count; ++i) {
        const test::Corners c = right_triangle(random);
        mesh.add(c[0], c[1], c[2]);
    }
    return mesh;
}

// 0 has either sign.
Float3 lattice_direction(Random& random) {
    Float3 d;
    do {
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const float size[] = {0, 1, 2};
            component(d, axis) = sign(random) * size[random.below(3)];
        }
    } while (max_norm(d) == 0);
    return d;
}

Float3 axis_direction(Random& random) {
    Float3 d(0 * sign(random), 0 * sign(random), 0 * sign(random));
    component(d, random.below(3)) = sign(random);
    return d;
}

// A corner, or what lies between two.
Float3 lattice_target(Random& random, const Mesh& mesh) {
    test::Corners c;
    mesh.corners(random.below(mesh.triangle_count()), &c);
    const uint32_t k = random.below(3);
    const Float3 middle = 0.5f * (c[k] + c[(k + 1) % 3]);
    const bool is_integer = std::floor(middle.x) == middle.x &&
                            std::floor(middle.y) == middle.y &&
                            std::floor(middle.z) == middle.z;
    return is_integer && random.chance(0.5f) ? middle : c[k];
}

// t = 1 .. 8 at a corner or an edge, unless something is nearer.
template <class MakeDirection>
test::Rays rays_at_lattice(Random& random, const Mesh& mesh, uint32_t side,
                           MakeDirection direction) {
    test::Rays rays = {{}, side, side};
    for (uint32_t i = 0; i < side * side; ++i) {
        const Float3 d = direction(random), to = lattice_target(random, mesh);
        rays.rays.push_back(test::make_ray(to - float(1 + random.below(8)) * d, d));
    }
    return rays;
}

Scene lattice_edges(Random& random, Extent e) {
    const Mesh mesh = right_triangles(random, e.triangles);
    return {mesh, rays_at_lattice(random, mesh, e.side, lattice_direction)};
}

Scene axis_parallel(Random& random, Extent e) {
    const Mesh mesh = right_triangles(random, e.triangles);
    return {mesh, rays_at_lattice(random, mesh, e.side, axis_direction)};
}

Scene duplicates(Random& random, Extent e) {
    const Mesh once = right_triangles(random, std::max(e.triangles / 4, 1u));
    const Mesh mesh = test::turned_copies(random, once, e.triangles);
    return {mesh, rays_at_lattice(random, mesh, e.side, lattice_direction)};
}

// Many in one plane: what a ray hits, it hits at one t.
Scene coplanar_layers(Random& random, Extent e) {
    Mesh mesh;
    while (mesh.triangle_count() < 16 * e.triangles) {
        const test::Corners c = right_triangle(random);
        if (c[0].z == c[1].z && c[1].z == c[2].z)
            mesh.add({c[0].x, c[0].y, 1}, {c[1].x, c[1].y, 1}, {c[2].x, c[2].y, 1});
    }
    return {mesh, rays_at_lattice(random, mesh, e.side, lattice_direction)};
}

// tmin and tmax at a hit, the next floats before and behind it, and the least and largest there are.
Scene interval_limits(Random& random, Extent e) {
    Scene scene = lattice_edges(random, e);
    const float largest = std::numeric_limits<float>::max();
    const float infinite = std::numeric_limits<float>::infinity();
    for (rsh_ray& ray : scene.rays.rays) {
        const float t = float(1 + random.below(8));
        const float at[] = {t, std::nextafter(t, 0.0f), std::nextafter(t, 16.0f)};
        const float least[] = {-infinite, -largest, -0.0f, 0x1p-126f};
        const float greatest[] = {infinite, largest, 0.0f, 0x1p-126f};
        float& tmin = ray.origin_tmin.s[3];
        float& tmax = ray.direction_tmax.s[3];
        if (random.chance(0.6f)) tmin = at[random.below(3)];
        if (random.chance(0.6f)) tmax = at[random.below(3)];
        if (random.chance(0.2f)) tmin = least[random.below(4)];
        if (random.chance(0.2f)) tmax = greatest[random.below(4)];
    }
    return scene;
}

// 100,000 triangles at one t for every ray that meets their plane; a few small ones before them
// leave it open which is the first. Few rays, as each of them has to look at all, and hits all.
Scene layers_1e5(Random& random, Extent e) {
    constexpr uint32_t kLayers = 100000;
    const auto around = [&] { return -float(kHalf) * float(1 + random.below(2)); };
    Mesh mesh;
    while (mesh.triangle_count() < e.triangles / 4) {
        const test::Corners c = right_triangle(random);
        if (c[0].z == c[1].z && c[1].z == c[2].z)
            mesh.add({c[0].x, c[0].y, 0}, {c[1].x, c[1].y, 0}, {c[2].x, c[2].y, 0});
    }
    while (mesh.triangle_count() < kLayers + e.triangles / 4) {
        const Float3 at(around(), around(), 0);
        mesh.add(at, at + Float3(64, 0, 0), at + Float3(0, 64, 0));
    }
    const uint32_t side = std::clamp(e.side / 8, 4u, 8u);
    test::Rays rays = {{}, side, side};
    for (uint32_t i = 0; i < side * side; ++i) {
        Float3 d = lattice_direction(random), to = lattice_point(random);
        d.z = sign(random) * float(1u << random.below(2));
        to.z = 0;
        rays.rays.push_back(test::make_ray(to - float(1 + random.below(8)) * d, d));
    }
    return {mesh, rays};
}

// Rays that begin at corners, on edges and within triangles: t = 0 is a hit.
Scene lattice_starts(Random& random, Extent e) {
    Scene scene = lattice_edges(random, e);
    for (rsh_ray& ray : scene.rays.rays) {
        const Float3 d = test::direction(ray);
        ray = test::make_ray(lattice_target(random, scene.mesh), d);
    }
    return scene;
}

// Two triangles of the face that has `axis` at `level`.
void add_square(Mesh& mesh, uint32_t axis, float level, float x, float y, float size) {
    const auto corner = [&](float i, float j) {
        Float3 p;
        component(p, axis) = level;
        component(p, (axis + 1) % 3) = x + i * size;
        component(p, (axis + 2) % 3) = y + j * size;
        return p;
    };
    mesh.add(corner(0, 0), corner(1, 0), corner(0, 1));
    mesh.add(corner(1, 1), corner(0, 1), corner(1, 0));
}

// A closed cube. From inside, through shared edges and corners: nothing gets out.
Scene lattice_room(Random& random, Extent e) {
    const float size = e.triangles >= 3072 ? 1 : e.triangles >= 768 ? 2 : 4;
    Mesh mesh;
    for (const float level : {-1.0f * kHalf, 1.0f * kHalf})
        for (uint32_t axis = 0; axis < 3; ++axis)
            for (float x = -kHalf; x < kHalf; x += size)
                for (float y = -kHalf; y < kHalf; y += size)
                    add_square(mesh, axis, level, x, y, size);
    test::Rays rays = {{}, e.side, e.side};
    for (uint32_t i = 0; i < e.side * e.side; ++i)
        rays.rays.push_back(
            test::make_ray(lattice_point(random, kHalf - 1), lattice_direction(random)));
    return {mesh, rays};
}

}  // namespace

std::vector<Family> lattice_families() {
    return {{"lattice_edges", Kind::kLattice, lattice_edges},
            {"axis_parallel", Kind::kLattice, axis_parallel},
            {"duplicates", Kind::kLattice, duplicates},
            {"coplanar_layers", Kind::kLattice, coplanar_layers},
            {"layers_1e5", Kind::kLattice, layers_1e5},
            {"lattice_starts", Kind::kLattice, lattice_starts},
            {"interval_limits", Kind::kLattice, interval_limits},
            {"lattice_room", Kind::kLattice, lattice_room}};
}

}  // namespace bench::stability
