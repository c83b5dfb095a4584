// box_test.cpp - the bound `box`: every block contains its active rays, with the room that box.h
// asks for around their origins; every box of the scene contains its triangle or the boxes of
// its group.
#include <gtest/gtest.h>

#include <algorithm>

#include "../oracle/containment.hpp"
#include "../support/cases.hpp"
#include "../support/compare.hpp"
#include "../support/levels.hpp"
#include "../support/trace.hpp"

namespace {

using test::Float3;
using test::Long3;
using test::Rays;

// box.h pads by 64u of the largest component; rounding may take a few of them away.
constexpr long double kPad = 0x3cp-24L;

bool ends_at_one(const rsh_ray& ray) {
    return ray.direction_tmax.s[3] <= 1 && finite(test::origin(ray) + test::direction(ray));
}

bool contains(const oracle::BoxNode& node, const rsh_ray& ray, bool converging) {
    const Float3 o = test::origin(ray), d = test::direction(ray);
    const float tmax = ray.direction_tmax.s[3];
    if (!converging)
        return node.tmax >= tmax && oracle::contains(node, Long3(o), kPad * max_norm(o), d);
    if (!ends_at_one(ray))  // anywhere, in any direction
        return std::isinf(node.origin_high.x) && std::isinf(node.direction_low.z) &&
               oracle::contains(node, Long3(o), 0, d);
    return node.tmax >= 1 && oracle::contains(node, Long3(o) + Long3(d), kPad * max_norm(o),
                                              Float3(-d.x, -d.y, -d.z));
}

void expect_permutation(std::vector<uint32_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    for (uint32_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], i);
}

void expect_contains_all(const Rays& rays, bool converging) {
    const auto built = test::build_nodes(rays, RSH_BOUND_BOX, converging);
    const auto groups = test::nodes_of<rsh_node_group>(built);
    const rsh_levels& l = built.levels;
    ASSERT_EQ(l.count, 2u);
    const test::RayOrder order = test::ray_order(built);
    expect_permutation(order.rays);
    for (uint32_t tile = 0; tile < l.width[2] * l.height[2]; ++tile)
        for (uint32_t k = 0; k < 16; ++k) {
            const oracle::BoxNode node = oracle::child_of(groups[tile], k);
            EXPECT_EQ(groups[tile].is_converging[k], uint32_t(converging));
            uint32_t x, y;
            bool active = false;
            if (test::child_of(l, 1, tile, k, &x, &y) >= 0)
                for (const size_t place : test::rays_below(l, 1, x, y)) {
                    const uint32_t i = order.rays[place];
                    if (!test::is_active(rays.rays[i])) continue;
                    active = true;
                    ASSERT_TRUE(contains(node, rays.rays[i], converging))
                        << "ray " << i << " of block " << k << " of tile " << tile << ": "
                        << rays.rays[i];
                }
            ASSERT_TRUE(active || node.tmax < 0)
                << "block " << k << " of tile " << tile << ", tmax " << node.tmax;
        }
}

class Box : public ::testing::TestWithParam<test::NamedCase> {};

TEST_P(Box, ContainsEveryActiveRay) {
    test::Random random(3);
    const Rays rays = GetParam().make(random).rays;
    for (const bool converging : {false, true}) {
        SCOPED_TRACE(converging ? "converging" : "from the origins");
        expect_contains_all(rays, converging);
    }
}

bool is_empty(const rsh_box_group& group, uint32_t k) {
    for (int axis = 0; axis < 3; ++axis)
        if (group.low[axis][k] != INFINITY || group.high[axis][k] != -INFINITY) return false;
    return true;
}

// Corners of the triangle in place k; false if it is never hit.
bool corners_of(const rsh_cluster& cluster, uint32_t k, test::Corners* corners) {
    for (int i = 0; i < 3; ++i)
        (*corners)[i] = {cluster.corner[i][0][k], cluster.corner[i][1][k],
                         cluster.corner[i][2][k]};
    return finite((*corners)[0]) && finite((*corners)[1]) && finite((*corners)[2]);
}

// Bit for bit, or at infinity where the triangle is never hit.
::testing::AssertionResult is_triangle(const rsh_cluster& cluster, uint32_t k,
                                       const test::Mesh& mesh, uint32_t t) {
    test::Corners given, stored;
    const bool is_hit = t < mesh.triangle_count() && mesh.corners(t, &given) &&
                        finite(given[0]) && finite(given[1]) && finite(given[2]);
    const bool is_finite = corners_of(cluster, k, &stored);
    for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const float expected = is_hit ? (&given[i].x)[axis] : INFINITY;
            if (cluster.corner[i][axis][k] != expected)
                return ::testing::AssertionFailure()
                       << "triangle " << t << ", corner " << i << ", axis " << axis << ": "
                       << cluster.corner[i][axis][k] << " instead of " << expected;
        }
    return (is_finite == is_hit ? ::testing::AssertionSuccess()
                                : ::testing::AssertionFailure());
}

// The triangles, padded.
::testing::AssertionResult holds_cluster(const rsh_box_group& above, uint32_t k,
                                         const rsh_cluster& cluster) {
    for (uint32_t t = 0; t < 16; ++t) {
        test::Corners c;
        if (!corners_of(cluster, t, &c)) continue;
        for (const Float3& p : c) {
            const long double pad = kPad * max_norm(p);
            const float at[3] = {p.x, p.y, p.z};
            for (int axis = 0; axis < 3; ++axis)
                if (!(above.low[axis][k] <= at[axis] - pad &&
                      above.high[axis][k] >= at[axis] + pad))
                    return ::testing::AssertionFailure()
                           << "place " << t << ", axis " << axis << ": " << at[axis]
                           << " is not inside " << above.low[axis][k] << " .. "
                           << above.high[axis][k];
        }
    }
    return ::testing::AssertionSuccess();
}

// Outside of the sizes that intersect.h takes as they are.
bool is_scaled(const rsh_cluster& cluster) {
    for (uint32_t t = 0; t < 16; ++t) {
        test::Corners c;
        if (!corners_of(cluster, t, &c)) continue;
        const float size = std::max(max_norm(c[1] - c[0]), max_norm(c[2] - c[0]));
        if (!(size >= 0x1p-20f && size <= 0x1p20f)) return true;
    }
    return false;
}

bool holds_group(const rsh_box_group& above, uint32_t k, const rsh_box_group& below) {
    for (int axis = 0; axis < 3; ++axis)
        for (uint32_t b = 0; b < 16; ++b)
            if (!(above.low[axis][k] <= below.low[axis][b] &&
                  above.high[axis][k] >= below.high[axis][b]))
                return false;
    return true;
}

void expect_clusters(const test::Mesh& mesh, const test::SceneBoxes& boxes) {
    expect_permutation(boxes.order);
    for (uint32_t i = 0; i < 16 * boxes.clusters.size(); ++i) {
        const uint32_t t = i < boxes.order.size() ? boxes.order[i] : i;
        ASSERT_TRUE(is_triangle(boxes.clusters[i / 16], i % 16, mesh, t)) << "place " << i;
    }
    for (uint32_t i = 0; i < boxes.clusters.size(); ++i)
        EXPECT_EQ((boxes.scaled[i / 16] >> i % 16 & 1) != 0, is_scaled(boxes.clusters[i]))
            << "cluster " << i;
}

// Level by level: each box holds the cluster or the group with its number.
void expect_contained(const test::Mesh& mesh, const test::SceneBoxes& boxes) {
    expect_clusters(mesh, boxes);
    const auto& groups = boxes.groups;
    uint32_t below = 0, first = 0;  // groups of the level below, and of this
    for (uint32_t count = uint32_t(boxes.clusters.size()); count > 0;) {
        const uint32_t here = (count + 15) / 16;
        ASSERT_LE(first + here, groups.size());
        for (uint32_t i = 0; i < 16 * here; ++i) {
            const rsh_box_group& group = groups[first + i / 16];
            if (i >= count)
                ASSERT_TRUE(is_empty(group, i % 16)) << "box " << i;
            else if (first == 0)
                ASSERT_TRUE(holds_cluster(group, i % 16, boxes.clusters[i])) << "box " << i;
            else
                ASSERT_TRUE(holds_group(group, i % 16, groups[below + i])) << "box " << i;
        }
        if (here == 1) break;
        below = first;
        first += here;
        count = here;
    }
}

TEST_P(Box, OfTheSceneContainsWhatIsBelowIt) {
    test::Random random(5);
    const test::Mesh mesh = GetParam().make(random).mesh;
    expect_contained(mesh, test::bound_boxes(test::DeviceMesh(mesh)));
}

INSTANTIATE_TEST_SUITE_P(All, Box, ::testing::ValuesIn(test::all_cases()), test::case_name);

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

// Per cell `count` triangles, one after the other; before them `count` each at the ends of a cube
// from 0 to 127.
std::vector<Float3> fill(const std::vector<Float3>& cells, uint32_t count) {
    std::vector<Float3> points(count, Float3(0, 0, 0));
    points.insert(points.end(), count, Float3(126.98f, 126.98f, 126.98f));
    for (const Float3& cell : cells) points.insert(points.end(), count, cell);
    return points;
}

// Cells that follow each other share a face; in a cell, triangles come as they came.
void expect_no_jumps(const std::vector<Float3>& points, float side, uint32_t per_cell) {
    const test::SceneBoxes boxes = test::bound_boxes(test::DeviceMesh(triangles_at(points)));
    expect_permutation(boxes.order);
    std::vector<uint32_t> order = boxes.order;
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

TEST(BoxOrder, LeavesCompactRunsTogether) {
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
    const test::SceneBoxes boxes = test::bound_boxes(test::DeviceMesh(mesh));
    expect_contained(mesh, boxes);
    for (uint32_t i = 0; i < triangles; ++i)
        EXPECT_EQ(boxes.order[i] % 40 == 39, i < large) << "place " << i;
}

TEST(BoxSizes, ContainRaysInGridsOfAnyShape) {
    test::Random random(4);
    const uint32_t shapes[][2] = {{1, 1}, {2, 1}, {1, 131}, {257, 1}, {17, 3}, {64, 65}};
    for (const auto& shape : shapes) {
        SCOPED_TRACE(std::to_string(shape[0]) + " x " + std::to_string(shape[1]));
        expect_contains_all(test::random_rays(random, shape[0], shape[1]), false);
    }
    expect_contains_all(test::converging_rays(random, 61, 47, {0.2f, 0.9f, 0.1f}), true);
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
    for (const rsh_node_group& group : test::nodes_of<rsh_node_group>(built))
        for (uint32_t k = 0; k < 16; ++k) {
            const oracle::BoxNode node = oracle::child_of(group, k);
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
    const auto built = test::build_nodes(rays, RSH_BOUND_BOX, false);
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
    EXPECT_FALSE(test::ray_order(test::build_nodes(rays, RSH_BOUND_BOX, false)).is_sorted);
    expect_contains_all(rays, false);
}

// Nothing but directions tells such rays apart.
TEST(RayOrder, SortsRaysFromOnePointByTheirOctant) {
    test::Random random(10);
    Rays rays = {std::vector<rsh_ray>(1024), 1024, 1};
    for (rsh_ray& ray : rays.rays) ray = test::make_ray(Float3(1, 2, 3), random.direction());
    const test::RayOrder order = test::ray_order(test::build_nodes(rays, RSH_BOUND_BOX, false));
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
