// spawned_families.cpp - rays as rsh_spawn makes them, of rays that hit closed bodies anywhere, at
// edges, corners and down to 2^-27 beside them, from outside and from inside.
#include <cfloat>
#include <cmath>
#include <limits>

#include "stability/spawned/critical_rays.hpp"

namespace bench::stability {
namespace {

using test::Body;
using test::Random;

rsh_material mirror() {
    rsh_material material = {};
    material.reflection = {{1, 1, 1, 0}};
    material.texture = RSH_NO_TEXTURE;
    return material;
}
rsh_material matte() {
    rsh_material material = {};
    material.diffuse = {{1, 1, 1, 0}};
    material.texture = RSH_NO_TEXTURE;
    return material;
}
rsh_material glass(float index) {
    rsh_material material = {};
    material.transmission = {{1, 1, 1, index}};
    material.texture = RSH_NO_TEXTURE;
    return material;
}
// Sends out rays of all kinds.
rsh_material shiny_glass(float index) {
    rsh_material material = glass(index);
    material.reflection = mirror().reflection;
    material.diffuse = matte().diffuse;
    return material;
}

template <class Make>
std::vector<rsh_material> materials_of(const std::vector<float>& indices, Make make) {
    std::vector<rsh_material> materials;
    for (const float index : indices) materials.push_back(make(index));
    return materials;
}

const std::vector<float>& indices() {
    static const std::vector<float> all = {1.5f, 1.0f, 0.6f, 2.4f, 1 + 0x1p-12f};
    return all;
}

// Between the bodies, or on one of their corners.
rsh_light lamp(Random& random, const Crowd& crowd) {
    test::Float3 at = crowd.mesh.vertices[random.below(uint32_t(crowd.mesh.vertices.size()))];
    if (random.chance(0.5f)) {
        const test::Placement& place =
            crowd.places[random.below(uint32_t(crowd.places.size()))];
        const test::Double3 beside = place.offset + test::Double3(2, 2, 2);
        at = test::Float3(place.scale * (beside + 0.2 * test::Double3(random.in_cube())));
    }
    rsh_light light = {};
    light.position = {{at.x, at.y, at.z, 0}};
    light.colour = {{1, 1, 1, 0}};
    light.kind = RSH_LIGHT_POINT;
    light.casts_shadow = 1;
    return light;
}

// A material per body, in turn.
Scene crowd_scene(Random& random, const Crowd& crowd, uint32_t side,
                  const std::vector<rsh_material>& materials,
                  const std::vector<uint32_t>& kinds) {
    Scene scene = {crowd.mesh, rays_at_crowd(random, crowd, side)};
    Spawning spawning = {{}, materials, crowd.body_of, lamp(random, crowd)};
    for (uint32_t& id : spawning.material_ids) id %= uint32_t(materials.size());
    for (size_t i = 0; i < scene.rays.rays.size(); ++i)
        spawning.kinds.push_back(kinds[random.below(uint32_t(kinds.size()))]);
    scene.spawning = spawning;
    return scene;
}

Crowd convex_crowd(Random& random, Extent e) {
    return make_crowd(
        random,
        {test::sphere_body(10, 5), test::box_body({1, 1, 1}), test::box_body({1, 0.1, 1}),
         test::box_body({1, 1e-2, 1e-2}), test::frustum(1e-2)},
        e.triangles);
}

Scene spawned_reflected(Random& random, Extent e) {
    return crowd_scene(random, convex_crowd(random, e), e.side, {mirror()},
                       {RSH_SPAWN_REFLECTION});
}

Scene spawned_refracted(Random& random, Extent e) {
    return crowd_scene(random, convex_crowd(random, e), e.side, materials_of(indices(), glass),
                       {RSH_SPAWN_REFRACTION});
}

Scene spawned_shadow(Random& random, Extent e) {
    Scene scene =
        crowd_scene(random, convex_crowd(random, e), e.side, {matte()}, {RSH_SPAWN_SHADOW});
    scene.is_converging = true;
    return scene;
}

// Edges and notches of least .. 180 - least degrees, half of them near these limits.
std::vector<Body> edged_bodies(Random& random, float least) {
    std::vector<Body> bodies;
    for (uint32_t i = 0; i < 64; ++i) {
        const float from_limit = least * std::pow(90 / least, random.unit());
        const float degrees = random.chance(0.5f)   ? random.between(least, 180 - least)
                              : random.chance(0.5f) ? from_limit
                                                    : 180 - from_limit;
        bodies.push_back(i % 2 ? test::dart(double(degrees)) : test::wedge(double(degrees)));
    }
    return bodies;
}

Scene at_edges(Random& random, Extent e, float least, const Place& place) {
    return crowd_scene(random,
                       make_crowd(random, edged_bodies(random, least), e.triangles, place),
                       e.side, materials_of(indices(), shiny_glass),
                       {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION, RSH_SPAWN_SHADOW});
}

Scene spawned_at_edges(Random& random, Extent e) {
    return at_edges(random, e, 1, {});
}
Scene spawned_1e_10(Random& random, Extent e) {
    return at_edges(random, e, 1, {1e-10, {}});
}
Scene spawned_1e10(Random& random, Extent e) {
    return at_edges(random, e, 1, {1e10, {}});
}
// Not so thin that rounding their corners leaves nothing of the bodies.
Scene spawned_offsets(Random& random, Extent e) {
    const double far = std::pow(10.0, double(random.between(1, 3.5f)));
    return at_edges(random, e, 20, {1, far * test::Double3(random.direction())});
}

Scene spawned_critical_angle(Random& random, Extent e) {
    const Crowd crowd = make_crowd(random, {test::sphere_body(10, 5)}, e.triangles);
    const std::vector<float> some = critical_indices(random, 64);
    Scene scene = crowd_scene(random, crowd, e.side, materials_of(some, glass),
                              {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION});
    std::vector<float> index_of;
    for (uint32_t& id : scene.spawning->material_ids) {
        id = random.below(uint32_t(some.size()));
        index_of.push_back(some[id]);
    }
    scene.rays = critical_rays(random, crowd, index_of, e.side);
    return scene;
}

// Per triangle: no indices, and those that overflow or vanish when they are squared.
Scene spawned_odd_indices(Random& random, Extent e) {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> odd = {
        0.0f,  -0.0f,  -1.0f,   -1.5f,   -FLT_MAX, infinity,     -infinity,   NAN,
        -NAN,  1e-45f, 1e-40f,  FLT_MIN, 1e-30f,   1e-18f,       1e-10f,      1e10f,
        1e18f, 1e30f,  FLT_MAX, -1e-45f, 1.0f,     1 - 0x1p-24f, 1 + 0x1p-23f};
    Scene scene = crowd_scene(random, convex_crowd(random, e), e.side, materials_of(odd, glass),
                              {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION});
    for (uint32_t& id : scene.spawning->material_ids) id = random.below(uint32_t(odd.size()));
    return scene;
}

}  // namespace

std::vector<Family> spawned_families() {
    return {{"spawned_reflected", Kind::kSpawned, spawned_reflected},
            {"spawned_refracted", Kind::kSpawned, spawned_refracted},
            {"spawned_shadow", Kind::kSpawned, spawned_shadow},
            {"spawned_at_edges", Kind::kSpawned, spawned_at_edges},
            {"spawned_1e-10", Kind::kSpawned, spawned_1e_10},
            {"spawned_1e10", Kind::kSpawned, spawned_1e10},
            {"spawned_offsets", Kind::kSpawned, spawned_offsets},
            {"spawned_critical_angle", Kind::kSpawned, spawned_critical_angle},
            {"spawned_odd_indices", Kind::kSpawned, spawned_odd_indices}};
}

}  // namespace bench::stability
