// filter_test.cpp - sides and meshes that rays do not see: what is left are the hits of brute force, and
// those that a host picks from all hits by normals in double precision.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::Corners;
using test::DeviceMesh;
using test::Double3;
using test::Rays;
using test::TraceOptions;

const std::vector<rsh_mesh_range> kRanges = {
    {0, 1, 0x1u, 0}, {100, 2, 0x6u, 0}, {100, 3, 0x4u, 0}, {230, 4, 0x80000000u, 0}};

uint32_t mask_of(uint32_t triangle) {
    uint32_t mask = 0;
    for (const rsh_mesh_range& range : kRanges)
        if (range.first_triangle <= triangle) mask = range.mask;
    return mask;
}

// Above 0: the ray sees the front.
double front_of(const test::Mesh& mesh, uint32_t triangle, const rsh_ray& ray) {
    Corners c;
    EXPECT_TRUE(mesh.corners(triangle, &c));
    const Double3 v0(c[0]), v1(c[1]), v2(c[2]);
    return -dot(cross(v1 - v0, v2 - v0), Double3(test::direction(ray)));
}

class Filter : public ::testing::Test {
protected:
    Filter() { mesh_.divide(kRanges); }

    void take_masks(Rays& rays) {
        for (size_t i = 0; i < rays.rays.size(); ++i)
            rays.masks.push_back(random_.chance(0.1f) ? 0u : uint32_t(random_.bits()));
    }

    // All hits that the host leaves, with the offsets of each ray's.
    test::HitLists seen(const test::HitLists& all, const Rays& rays, cl_uint cull) const {
        test::HitLists left;
        for (size_t i = 0; i < rays.rays.size(); ++i) {
            left.offsets.push_back(left.hits.size());
            for (uint64_t h = all.offsets[i]; h < all.offsets[i + 1]; ++h) {
                const uint32_t triangle = all.hits[h].primitive;
                const bool is_front = front_of(host_, triangle, rays.rays[i]) > 0;
                if (cull == (is_front ? RSH_CULL_FRONT : RSH_CULL_BACK)) continue;
                if (!rays.masks.empty() && !(rays.masks[i] & mask_of(triangle))) continue;
                left.hits.push_back(all.hits[h]);
            }
        }
        left.offsets.push_back(left.hits.size());
        return left;
    }

    // Of `mesh`, all answers of each engine are those of brute force.
    void expect_those_of_brute_force(const DeviceMesh& mesh, const Rays& rays, cl_uint cull) {
        TraceOptions force = test::brute_force();
        force.cull = cull;
        const auto hits = closest_hits(mesh, rays, force);
        const std::vector<uint32_t> masks(rays.rays.size(), 0xa5a50000u);
        const auto hidden = occlusion(mesh, rays, masks, 3, force);
        const auto counts = hit_counts(mesh, rays, force);
        const test::HitLists lists = all_hits(mesh, rays, force);
        for (TraceOptions way : test::all_ways())
            for (const size_t budget : {size_t{0}, size_t{RSH_MIN_BUDGET}}) {
                SCOPED_TRACE(name_of(way) + ", budget " + std::to_string(budget));
                way.cull = cull;
                way.budget = budget;
                EXPECT_TRUE(test::same_bits(closest_hits(mesh, rays, way), hits, "hits"));
                EXPECT_TRUE(
                    test::same_bits(occlusion(mesh, rays, masks, 3, way), hidden, "masks"));
                EXPECT_TRUE(test::same_bits(hit_counts(mesh, rays, way), counts, "counts"));
                EXPECT_TRUE(
                    test::same_bits(all_hits(mesh, rays, way).hits, lists.hits, "all hits"));
            }
    }

    test::Random random_{71};
    const test::Mesh host_ = test::random_soup(random_, 300, 0.4f);
    DeviceMesh mesh_{host_};
};

TEST_F(Filter, LeavesWhatTheHostLeaves) {
    Rays rays = test::random_rays(random_, test::small() ? 20 : 90, 23);
    const TraceOptions force = test::brute_force();
    const test::HitLists all = all_hits(mesh_, rays, force);
    for (const bool has_masks : {false, true}) {
        if (has_masks) take_masks(rays);
        for (const cl_uint cull : {RSH_CULL_NONE, RSH_CULL_BACK, RSH_CULL_FRONT}) {
            SCOPED_TRACE("cull " + std::to_string(cull) + ", masks " +
                         std::to_string(has_masks));
            TraceOptions way = force;
            way.cull = cull;
            const test::HitLists expected = seen(all, rays, cull),
                                 actual = all_hits(mesh_, rays, way);
            EXPECT_TRUE(test::same_bits(actual.offsets, expected.offsets, "offsets"));
            EXPECT_TRUE(test::same_bits(actual.hits, expected.hits, "all hits"));
            const auto closest = closest_hits(mesh_, rays, way);
            for (size_t i = 0; i < closest.size(); ++i) {
                const bool is_hit = expected.offsets[i] != expected.offsets[i + 1];
                const uint32_t primitive =
                    is_hit ? expected.hits[expected.offsets[i]].primitive : RSH_NO_HIT;
                EXPECT_EQ(closest[i].primitive, primitive) << "ray " << i;
            }
        }
    }
}

TEST_F(Filter, LeavesTheSameInEveryEngine) {
    Rays rays[] = {test::pinhole_rays(test::small() ? 17 : 49, 31),
                   test::random_rays(random_, test::small() ? 100 : 900, 1),
                   test::leaving_rays(random_, host_, test::small() ? 16 : 40, 20)};
    for (Rays& some : rays) {
        expect_those_of_brute_force(mesh_, some, RSH_CULL_FRONT);
        take_masks(some);
        expect_those_of_brute_force(mesh_, some, RSH_CULL_NONE);
        expect_those_of_brute_force(mesh_, some, RSH_CULL_BACK);
    }
    const DeviceMesh degenerate(test::degenerate_soup(random_, test::small() ? 60 : 300));
    expect_those_of_brute_force(degenerate, rays[0], RSH_CULL_BACK);
    const DeviceMesh turned(test::turned_copies(random_, host_, test::small() ? 100 : 600));
    expect_those_of_brute_force(turned, rays[1], RSH_CULL_BACK);
}

// As often in as out, of a closed mesh that rays see from outside.
void expect_turns(const test::Mesh& host, const Rays& rays) {
    const DeviceMesh mesh(host);
    TraceOptions way = test::brute_force();
    way.cull = RSH_CULL_BACK;
    const auto fronts = hit_counts(mesh, rays, way);
    way.cull = RSH_CULL_FRONT;
    EXPECT_TRUE(test::same_bits(hit_counts(mesh, rays, way), fronts, "backs"));
    EXPECT_GT(*std::max_element(fronts.begin(), fronts.end()), 0u);
}

TEST_F(Filter, MakesSidesTakeTurnsAtCornersAndEdges) {
    for (const test::Mesh& host : {test::torus(17, 13), test::sphere(16, 12)})
        expect_turns(host, test::rays_at_edges(random_, host, test::small() ? 20 : 60, 40));
}

// So flat that products of its corners vanish, seen from the side.
TEST_F(Filter, MakesSidesOfNeedlesTakeTurns) {
    test::Mesh flat = test::torus(17, 13);
    for (test::Float3& v : flat.vertices) v.y *= 0x1p-130f;
    Rays rays;
    for (const test::Float3& v : flat.vertices)
        for (const float side : {-1.0f, 1.0f})
            rays.rays.push_back(test::make_ray({v.x - 4 * side, v.y, v.z}, {side, 0.0f, 0.0f}));
    rays.width = uint32_t(rays.rays.size());
    expect_turns(flat, rays);
}

TEST_F(Filter, IsThatOfAudits) {
    Rays rays = test::random_rays(random_, 300, 1);
    take_masks(rays);
    TraceOptions way = test::all_ways()[0];
    way.cull = RSH_CULL_BACK;
    const test::Buffer<rsh_hit> hits(closest_hits(mesh_, rays, way));
    const test::Buffer<rsh_ray> given(rays.rays);
    const test::Buffer<uint32_t> masks(rays.masks);
    const test::Buffer<rsh_audit_report> report(1);
    rsh_audit_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = mesh_.geometry();
    desc.ray_count = 300;
    desc.rays = given.get();
    desc.hits = hits.get();
    desc.report = report.get();
    desc.ray_masks = masks.get();
    const auto differences = [&](cl_uint cull) {
        desc.cull = cull;
        RSH_CHECK(
            rsh_audit(test::device().rsh, test::device().queue(), &desc, 0, nullptr, nullptr));
        return report.read()[0].differences;
    };
    const test::Buffer<uint32_t> counts(hit_counts(mesh_, rays, way));
    desc.query = RSH_QUERY_COUNT;
    desc.hit_counts = counts.get();
    EXPECT_EQ(differences(RSH_CULL_BACK), 0u);
    EXPECT_GT(differences(RSH_CULL_FRONT), 10u);
    desc.query = RSH_QUERY_CLOSEST;
    EXPECT_EQ(differences(RSH_CULL_BACK), 0u);
    EXPECT_GT(differences(RSH_CULL_FRONT), 10u);
    desc.ray_masks = nullptr;
    EXPECT_GT(differences(RSH_CULL_BACK), 10u);
}

}  // namespace
