#include "bvh/box_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bvh/types.h"
#include "oracle/containment.hpp"
#include "rays/types.h"
#include "support/compare.hpp"
#include "support/levels.hpp"

namespace {

using test::Float3;
using test::Long3;
using test::Rays;

// rays/box_node.h pads by 64u of the largest component; rounding may take a few of them away.
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

// Outside of the sizes that mesh/intersect.h takes as they are.
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

// What is below each box of a group, and so on; marks groups and clusters.
class Walk {
public:
    Walk(const test::Mesh& mesh, const test::SceneBoxes& boxes) : mesh_(mesh), boxes_(boxes) {}

    void check_group(uint32_t number, uint32_t depth) {
        ASSERT_LE(depth, uint32_t{RSH_MAX_BOX_DEPTH});
        ASSERT_LT(number, boxes_.groups.size());
        ASSERT_TRUE(groups_.insert(number).second) << "group " << number << " twice";
        const rsh_box_group& group = boxes_.groups[number];
        for (uint32_t k = 0; k < 16; ++k) {
            SCOPED_TRACE("group " + std::to_string(number) + ", box " + std::to_string(k));
            if (group.below[k] == RSH_NO_BOX) {
                ASSERT_TRUE(is_empty(group, k));
            } else if (group.below[k] & RSH_IS_CLUSTER) {
                check_cluster(group, k);
            } else {
                ASSERT_LT(group.below[k], boxes_.groups.size());
                ASSERT_TRUE(holds_group(group, k, boxes_.groups[group.below[k]]));
                check_group(group.below[k], depth + 1);
            }
            if (::testing::Test::HasFatalFailure()) return;
        }
    }

    BoxCounts counts() const { return {clusters_.size(), groups_.size()}; }

    // In the order of the clusters.
    std::vector<uint32_t> order() const {
        std::vector<uint32_t> order;
        for (const uint32_t number : clusters_)
            for (const uint32_t t : boxes_.clusters[number].triangle)
                if (t != RSH_NO_HIT) order.push_back(t);
        return order;
    }

    // Those that no group names.
    void expect_others_empty() const {
        for (uint32_t c = 0; c < boxes_.clusters.size(); ++c) {
            if (clusters_.count(c)) continue;
            for (uint32_t k = 0; k < 16; ++k)
                ASSERT_TRUE(is_triangle(boxes_.clusters[c], k, mesh_, RSH_NO_HIT));
        }
    }

private:
    void check_cluster(const rsh_box_group& group, uint32_t k) {
        const uint32_t number = RSH_BELOW_NUMBER(group.below[k]);
        ASSERT_LT(number, boxes_.clusters.size());
        ASSERT_TRUE(clusters_.insert(number).second) << "cluster " << number << " twice";
        const rsh_cluster& cluster = boxes_.clusters[number];
        EXPECT_EQ((group.below[k] & RSH_SCALED) != 0, is_scaled(cluster));
        ASSERT_TRUE(holds_cluster(group, k, cluster));
        for (uint32_t i = 0; i < 16; ++i)
            ASSERT_TRUE(is_triangle(cluster, i, mesh_, cluster.triangle[i])) << "place " << i;
    }

    const test::Mesh& mesh_;
    const test::SceneBoxes& boxes_;
    std::set<uint32_t> groups_, clusters_;
};

}  // namespace

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

void expect_contained(const test::Mesh& mesh, const test::SceneBoxes& boxes,
                      BoxCounts* counts) {
    expect_permutation(boxes.order);
    if (mesh.triangle_count() == 0) return;
    Walk walk(mesh, boxes);
    walk.check_group(boxes.head.groups.end - 1, 1);
    if (::testing::Test::HasFatalFailure()) return;
    EXPECT_EQ(walk.order(), boxes.order);
    walk.expect_others_empty();
    if (counts) *counts = walk.counts();
}
