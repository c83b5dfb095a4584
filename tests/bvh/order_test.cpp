// order_test.cpp - the orders that the shape `box` gives triangles, and rays of a list.
#include <gtest/gtest.h>

#include <algorithm>

#include "bvh/box_checks.hpp"
#include "oracle/containment.hpp"
#include "rays/types.h"

namespace {

using test::Float3;
using test::Rays;

// A small triangle around each point.
test::Mesh triangles_at(const std::vector<Float3>& points) {
    test::Mesh mesh;
    for (const Float3& p : points)
        mesh.add(p, p + Float3(0.01f, 0, 0), p + Float3(0, 0.01f, 0));
    return mesh;
}

// The centres of 8 x 8 x 8 cells from 0 on, shuffled.
std::vector<Float3> shuffled_cells(test::Random& random, float side) {
    std::vector<Float3> cells;
    for (uint32_t i = 0; i < 512; ++i) {
        cells.emplace_back(side * (float(i % 8) + 0.5f), side * (float(i / 8 % 8) + 0.5f),
                           side * (float(i / 64) + 0.5f));
        std::swap(cells[i], cells[random.below(i + 1)]);
    }
    return cells;
}

// Per cell `count` triangles, one after the other; before them `count` each at the ends of a
// cube from 0 to 127.
std::vector<Float3> fill(const std::vector<Float3>& cells, uint32_t count) {
    std::vector<Float3> points(count, Float3(0, 0, 0));
    points.insert(points.end(), count, Float3(126.98f, 126.98f, 126.98f));
    for (const Float3& cell : cells) points.insert(points.end(), count, cell);
    return points;
}

// Cells that follow each other share a face; in a cell, triangles come as they came.
void expect_no_jumps(const std::vector<Float3>& points, float side, uint32_t per_cell) {
    const test::SceneBvh bvh = test::build_bvh(test::DeviceMesh(triangles_at(points)));
    expect_permutation(bvh.order);
    std::vector<uint32_t> order = bvh.order;
    order.erase(std::remove_if(order.begin(), order.end(),
                               [&](uint32_t t) { return t < 2 * per_cell; }),
                order.end());
    for (size_t i = 1; i < order.size(); ++i) {
        const Float3 step = points[order[i]] - points[order[i - 1]];
        const float length = std::fabs(step.x) + std::fabs(step.y) + std::fabs(step.z);
        ASSERT_EQ(length, i % per_cell ? 0.0f : side)
            << "place " << i << ": triangle " << order[i] << " after " << order[i - 1];
        ASSERT_TRUE(i % per_cell == 0 || order[i] == order[i - 1] + 1) << "place " << i;
    }
}

TEST(BoxOrder, FollowsACurveWithoutJumps) {
    test::Random random(6);
    expect_no_jumps(fill(shuffled_cells(random, 16), 1), 16, 1);
}

// Many to a bin of the first sort.
TEST(BoxOrder, FollowsTheCurveWhereTrianglesAreDense) {
    test::Random random(11);
    expect_no_jumps(fill(shuffled_cells(random, 2), 1), 2, 1);
}

TEST(BoxOrder, LeavesCompactRangesTogether) {
    test::Random random(8);
    expect_no_jumps(fill(shuffled_cells(random, 16), 16), 16, 16);
}

// Else every box around one of them would be large.
TEST(BoxOrder, PutsLargeTrianglesTogether) {
    test::Random random(7);
    const uint32_t triangles = test::small() ? 640 : 8000, large = triangles / 40;
    test::Mesh mesh;
    for (uint32_t t = 0; t < triangles; ++t) {
        const float size = t % 40 == 39 ? 0.5f : 0.01f;
        const Float3 p(random.unit(), random.unit(), random.unit());
        mesh.add(p, p + Float3(size, 0, 0), p + Float3(0, size, 0));
    }
    const test::SceneBvh bvh = test::build_bvh(test::DeviceMesh(mesh));
    expect_contained(mesh, bvh);
    for (uint32_t i = 0; i < triangles; ++i)
        EXPECT_EQ(bvh.order[i] % 40 == 39, i < large) << "place " << i;
}

// The way of a walker who turns at random.
std::vector<Float3> random_walk(test::Random& random, uint32_t count) {
    std::vector<Float3> points = {Float3(0, 0, 0)};
    while (points.size() < count) points.push_back(points.back() + 0.02f * random.direction());
    return points;
}

std::vector<Float3> shuffled(std::vector<Float3> points, test::Random& random) {
    for (size_t i = points.size() - 1; i > 0; --i)
        std::swap(points[i], points[random.below(uint32_t(i + 1))]);
    return points;
}

void expect_new_order(const std::vector<Float3>& points, const std::vector<Float3>& earlier) {
    const test::Mesh mesh = triangles_at(points);
    const test::DeviceMesh now(mesh), then(triangles_at(earlier));
    const test::SceneBvh bvh = test::refitted_bvhs({&then, &now})[1];
    EXPECT_EQ(bvh.order, test::build_bvh(now).order);
    expect_contained(mesh, bvh);
}

TEST(BoxOrder, IsKeptWhereTrianglesMoveTogether) {
    test::Random random(12);
    std::vector<Float3> points = random_walk(random, test::small() ? 700 : 20000);
    const test::DeviceMesh then(triangles_at(points));
    for (Float3& p : points)
        p = Float3(0.9f * p.y, 0.9f * p.x, p.z + 5 + 0.001f * random.unit());
    const test::Mesh moved = triangles_at(points);
    const test::DeviceMesh now(moved);
    const std::vector<test::SceneBvh> frames = test::refitted_bvhs({&then, &now});
    EXPECT_EQ(frames[1].order, frames[0].order);
    EXPECT_NE(frames[1].order, test::build_bvh(now).order);
    expect_contained(moved, frames[1]);
}

TEST(BoxOrder, IsMadeAnewWhereTrianglesPart) {
    test::Random random(13);
    const std::vector<Float3> points = random_walk(random, test::small() ? 700 : 20000);
    expect_new_order(shuffled(points, random), points);
}

// Leaves stay as they are, but those that follow each other move apart.
TEST(BoxOrder, IsMadeAnewWhereClustersPart) {
    test::Random random(14);
    const std::vector<Float3> cells = shuffled_cells(random, 16);
    expect_new_order(fill(shuffled(cells, random), 16), fill(cells, 16));
}

// As an application may have it that refits from the first frame on.
TEST(BoxOrder, IsMadeWhereBoundsHoldNothing) {
    test::Random random(16);
    const test::DeviceMesh mesh(triangles_at(random_walk(random, 700)));
    for (const uint8_t byte : {0x00, 0xcd, 0xff}) {
        SCOPED_TRACE("bytes " + std::to_string(byte));
        EXPECT_EQ(test::bvh_refitted_from(mesh, byte).order, test::build_bvh(mesh).order);
    }
}

// A refit looks back at the frame whose order it has, not at the one before.
TEST(BoxOrder, WearsByDegrees) {
    test::Random random(15);
    const std::vector<Float3> points = random_walk(random, test::small() ? 300 : 5000);
    const int count = test::small() ? 8 : 40;
    std::vector<Float3> drift;
    for (size_t i = 0; i < points.size(); ++i)
        drift.push_back(0.08f / float(count) * random.direction());
    const auto at = [&](int frame) {
        std::vector<Float3> now = points;
        for (size_t i = 0; i < now.size(); ++i) now[i] = now[i] + float(frame) * drift[i];
        return test::DeviceMesh(triangles_at(now));
    };
    std::vector<test::DeviceMesh> meshes;
    for (int frame = 0; frame < count; ++frame) meshes.push_back(at(frame));
    std::vector<const test::DeviceMesh*> frames;
    for (const test::DeviceMesh& mesh : meshes) frames.push_back(&mesh);
    const std::vector<test::SceneBvh> bvhs = test::refitted_bvhs(frames);
    int changes = 0;
    for (size_t i = 1; i < bvhs.size(); ++i) changes += bvhs[i].order != bvhs[i - 1].order;
    EXPECT_GE(changes, 1);
    EXPECT_LE(changes, count / 2);
}

// Rays that leave a sheet of n x n points, as a mirror's do; every 16th is inactive.
Rays sheet_of_rays(uint32_t n) {
    Rays rays = {std::vector<rsh_ray>(size_t(n) * n), n * n, 1};
    for (uint32_t i = 0; i < n * n; ++i) {
        const float x = float(i % n) / n, y = float(i / n) / n;
        rays.rays[i] = test::make_ray(Float3(x, y, 0), Float3(x - 0.5f, y - 0.5f, 1));
        if (i % 16 == 15) rays.rays[i].direction_tmax.s[3] = -1;
    }
    return rays;
}

// Longest side of a block's box of origins, on the average of those that hold rays.
float mean_side(const test::BuiltNodes& built) {
    float sum = 0;
    int count = 0;
    for (const box_node16& tile : test::nodes_of<box_node16>(built))
        for (uint32_t k = 0; k < 16; ++k) {
            const oracle::BoxNode node = oracle::child_of(tile, k);
            if (node.tmax < 0) continue;
            sum += max_norm(node.origin_high - node.origin_low);
            ++count;
        }
    return sum / float(count);
}

TEST(RayOrder, SortsListsWithoutNeighbours) {
    test::Random random(9);
    Rays rays = sheet_of_rays(test::small() ? 32 : 128);
    for (size_t i = rays.rays.size() - 1; i > 0; --i)
        std::swap(rays.rays[i], rays.rays[random.below(uint32_t(i + 1))]);
    const auto built = test::build_nodes(rays, RSH_SHAPE_BOX, false);
    const test::RayOrder order = test::ray_order(built);
    EXPECT_TRUE(order.is_sorted);
    expect_permutation(order.rays);
    expect_contains_all(rays, false);
    EXPECT_LT(mean_side(built), test::small() ? 0.25f : 0.06f);
    const size_t active = rays.rays.size() / 16 * 15;
    for (size_t i = 0; i < order.rays.size(); ++i)
        ASSERT_EQ(test::is_active(rays.rays[order.rays[i]]), i < active) << "place " << i;
}

TEST(RayOrder, LeavesListsOfNeighboursAlone) {
    const Rays rays = sheet_of_rays(test::small() ? 80 : 128);
    EXPECT_FALSE(test::ray_order(test::build_nodes(rays, RSH_SHAPE_BOX, false)).is_sorted);
    expect_contains_all(rays, false);
}

// Nothing but directions tells such rays apart.
TEST(RayOrder, SortsRaysFromOnePointByTheirOctant) {
    test::Random random(10);
    Rays rays = {std::vector<rsh_ray>(1024), 1024, 1};
    for (rsh_ray& ray : rays.rays) ray = test::make_ray(Float3(1, 2, 3), random.direction());
    const test::RayOrder order = test::ray_order(test::build_nodes(rays, RSH_SHAPE_BOX, false));
    EXPECT_TRUE(order.is_sorted);
    int changes = 0;
    for (size_t i = 1; i < order.rays.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            changes += (rays.rays[order.rays[i]].direction_tmax.s[axis] < 0) !=
                       (rays.rays[order.rays[i - 1]].direction_tmax.s[axis] < 0);
    EXPECT_EQ(changes, 4 + 2 + 1 + 4);  // of 8 octants in turn, bit by bit
    expect_contains_all(rays, false);
}

}  // namespace
