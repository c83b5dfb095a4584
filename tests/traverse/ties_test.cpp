// ties_test.cpp - t, and whether there is a hit, do not depend on the order of a triangle's
// corners: of coincident triangles, turned or reversed, every engine names the lowest index.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::Corners;
using test::Float3;
using test::Mesh;
using test::Random;
using test::Rays;

using Order = std::array<uint32_t, 3>;
constexpr Order kOrders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
constexpr uint32_t kOrderCount = 6;

void add(Mesh* mesh, const Mesh& from, uint32_t triangle, const Order& order) {
    Corners c;
    from.corners(triangle, &c);
    mesh->add(c[order[0]], c[order[1]], c[order[2]]);
}

Mesh in_order(const Mesh& mesh, const Order& order) {
    Mesh same;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) add(&same, mesh, i, order);
    return same;
}

// Every triangle in every order, at random indices. lowest: that of each triangle; ascending, so
// that of equal t the same triangle wins as in `mesh`.
Mesh all_orders_mixed(Random& random, const Mesh& mesh, std::vector<uint32_t>* lowest) {
    std::vector<uint32_t> left(kOrderCount * mesh.triangle_count());
    std::iota(left.begin(), left.end(), 0u);
    std::vector<uint32_t> triangle(mesh.triangle_count(), RSH_NO_HIT);  // by first appearance
    lowest->clear();
    Mesh mixed;
    for (uint32_t at = 0; !left.empty(); ++at) {
        std::swap(left[random.below(uint32_t(left.size()))], left.back());
        uint32_t& drawn = triangle[left.back() / kOrderCount];
        if (drawn == RSH_NO_HIT) {
            drawn = uint32_t(lowest->size());
            lowest->push_back(at);
        }
        add(&mixed, mesh, drawn, kOrders[left.back() % kOrderCount]);
        left.pop_back();
    }
    return mixed;
}

// Thin ones, down to those that are too thin to be hit.
Mesh needles(Random& random, uint32_t count) {
    Mesh mesh;
    for (uint32_t i = 0; i < count; ++i) {
        const Float3 a(0.25f * random.in_cube()), along = random.direction();
        const float width = std::exp2(random.between(-40, 0));
        mesh.add(a, a + along, a + random.unit() * along + width * random.direction());
    }
    return mesh;
}

// About the sizes where triangles begin to be scaled, whichever edges decide.
Mesh of_sizes_about(Random& random, uint32_t count, float size) {
    Mesh mesh;
    for (uint32_t i = 0; i < count; ++i)
        mesh.add(size * random.in_cube(), size * random.in_cube(), size * random.in_cube());
    return mesh;
}

struct Scene {
    Mesh mesh;
    Rays rays;
};

// A layer of triangles each, so thin that it depends on their scale whether they are seen at all.
Scene about_the_least_area(Random& random, uint32_t count, uint32_t side) {
    Scene scene{{}, {{}, side, side}};
    std::vector<Float3> inside;
    for (uint32_t i = 0; i < count; ++i) {
        const float length = std::exp2(random.between(20, 22)), z = -float(i);
        const float width = length * std::exp2(random.between(-105, -99));
        scene.mesh.add({0, 0, z}, {length, 0, z}, {0.5f * length, width, z});
        inside.push_back({0.5f * length, 0.25f * width, z + 0.5f});
    }
    for (uint32_t i = 0; i < side * side; ++i)
        scene.rays.rays.push_back(test::make_ray(inside[i % count], {0, 0, -1}));
    return scene;
}

// Rays that start in the triangles, at t = 0, from either side, where 0 has either sign.
Scene at_zero(Random& random, uint32_t count, uint32_t side) {
    Scene scene{{}, {{}, side, side}};
    while (scene.mesh.triangle_count() < count) {
        Float3 corner[3];
        for (Float3& c : corner)
            c = {random.between(-1, 1), random.between(-1, 1), random.chance(0.5f) ? -0.0f : 0};
        scene.mesh.add(corner[0], corner[1], corner[2]);
    }
    for (uint32_t i = 0; i < side * side; ++i)
        scene.rays.rays.push_back(
            test::make_ray({random.between(-1, 1), random.between(-1, 1), 0},
                           {0.25f, 0.125f, random.chance(0.5f) ? 1.0f : -1.0f}));
    return scene;
}

// 2^17 rays and more in all.
std::vector<Scene> scenes() {
    Random random(110);
    const uint32_t count = test::small() ? 20 : 60, side = test::small() ? 8 : 128;
    std::vector<Scene> all;
    for (const Mesh& mesh : {test::random_soup(random, count, 0.8f), needles(random, count),
                             test::square_triangles(random, count), test::grid(5)}) {
        all.push_back({mesh, test::random_rays(random, side, side)});
        all.push_back({mesh, test::rays_at_edges(random, mesh, side, side)});
    }
    for (const float scale : {0x1p-20f, 0x1p20f, 1e-15f, 1e15f}) {
        const Mesh mesh = of_sizes_about(random, count, scale);
        all.push_back({mesh, test::rays_at_edges(random, mesh, side / 2, side / 2)});
    }
    all.push_back(about_the_least_area(random, count, side / 2));
    all.push_back(at_zero(random, count, side / 2));
    return all;
}

// Bits; u and v are the weights of two corners, so of each two orders one weight is told by both.
void expect_same_hits(const std::vector<rsh_hit>& first, const std::vector<rsh_hit>& other,
                      const Order& order) {
    size_t wrong = 0;
    for (size_t i = 0; i < first.size(); ++i) {
        const rsh_hit &a = first[i], &b = other[i];
        bool is_same = a.primitive == b.primitive && std::memcmp(&a.t, &b.t, sizeof a.t) == 0;
        for (uint32_t k = 1; k < 3 && a.primitive != RSH_NO_HIT; ++k)
            if (order[k] != 0)
                is_same &=
                    std::memcmp(k == 1 ? &b.u : &b.v, order[k] == 1 ? &a.u : &a.v, 4) == 0;
        if (!is_same && wrong++ == 0)
            ADD_FAILURE() << "first ray " << i << ": " << b << ", in the first order " << a;
    }
    EXPECT_EQ(wrong, 0u) << "of " << first.size() << " rays, corners " << order[0] << " "
                         << order[1] << " " << order[2];
}

TEST(Ties, HitsAreTheSameInEveryOrderOfTheCorners) {
    size_t hits = 0;
    for (const Scene& scene : scenes()) {
        const auto first =
            closest_hits(test::DeviceMesh(scene.mesh), scene.rays, test::brute_force());
        for (const rsh_hit& hit : first) hits += hit.primitive != RSH_NO_HIT;
        for (const Order& order : kOrders)
            expect_same_hits(first,
                             closest_hits(test::DeviceMesh(in_order(scene.mesh, order)),
                                          scene.rays, test::brute_force()),
                             order);
    }
    EXPECT_GT(hits, 0u);
}

// Ray by ray: the t of the triangles alone, and the lowest index of the one that is hit.
void expect_lowest(const Scene& scene, const std::vector<rsh_hit>& alone,
                   const std::vector<uint32_t>& lowest, const std::vector<rsh_hit>& hits) {
    size_t wrong = 0;
    for (size_t i = 0; i < hits.size(); ++i) {
        const uint32_t none = RSH_NO_HIT;
        const uint32_t expected =
            alone[i].primitive == none ? none : lowest[alone[i].primitive];
        if (hits[i].primitive == expected &&
            std::memcmp(&hits[i].t, &alone[i].t, sizeof(float)) == 0)
            continue;
        if (wrong++ == 0)
            ADD_FAILURE() << "first ray " << i << " " << scene.rays.rays[i] << ": " << hits[i]
                          << ", must be t " << alone[i].t << ", primitive " << expected;
    }
    EXPECT_EQ(wrong, 0u) << "of " << hits.size() << " rays";
}

// By every width, each a program of its own, and every way.
void expect_lowest_of(const Scene& scene, Random& random, rsh_context context) {
    std::vector<uint32_t> lowest;
    const test::DeviceMesh mixed(all_orders_mixed(random, scene.mesh, &lowest));
    test::TraceOptions alone = test::brute_force();
    alone.context = context;
    const auto expected = closest_hits(test::DeviceMesh(scene.mesh), scene.rays, alone);
    for (test::TraceOptions way : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(way));
        way.context = context;
        expect_lowest(scene, expected, lowest, closest_hits(mixed, scene.rays, way));
    }
}

TEST(Ties, OfCoincidentTrianglesGoToTheLowestIndex) {
    for (const cl_uint width : {1u, 4u, 8u, 16u}) {
        SCOPED_TRACE("width " + std::to_string(width));
        Random random(111);
        const test::OwnContext context(width);
        for (const Scene& scene : scenes()) expect_lowest_of(scene, random, context.get());
    }
}

}  // namespace
