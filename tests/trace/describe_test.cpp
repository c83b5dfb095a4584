// describe_test.cpp - normals, points and meshes of hits, against double precision and a search from the
// front.
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/ways.hpp"
#include "trace/trace_call.hpp"

namespace {

using test::Corners;
using test::Double3;
using test::TraceWay;

Double3 normal_of(const test::Mesh& mesh, uint32_t triangle) {
    Corners c;
    EXPECT_TRUE(mesh.corners(triangle, &c));
    const Double3 v0(c[0]), v1(c[1]), v2(c[2]);
    return normalize(cross(v1 - v0, v2 - v0));
}

// How far a point is from where u and v say, as a share of the largest coordinate.
double error_of_point(const test::Mesh& mesh, const rsh_hit& hit, const test::Float3& point) {
    Corners c;
    EXPECT_TRUE(mesh.corners(hit.primitive, &c));
    const Double3 v0(c[0]), v1(c[1]), v2(c[2]);
    const Double3 expected = v0 + double(hit.u) * (v1 - v0) + double(hit.v) * (v2 - v0);
    const double largest = std::max({max_norm(v0), max_norm(v1), max_norm(v2)});
    return max_norm(Double3(point) - expected) / largest;
}

bool is_nowhere(const test::Float3& point) {
    return std::isnan(point.x) && std::isnan(point.y) && std::isnan(point.z);
}

// The last range that begins at the triangle or before it.
uint32_t id_of(const std::vector<rsh_mesh_range>& ranges, uint32_t triangle) {
    uint32_t id = ranges[0].id;
    for (const rsh_mesh_range& range : ranges)
        if (range.first_triangle <= triangle) id = range.id;
    return id;
}

class Describe : public ::testing::Test {
protected:
    void expect_descriptions(const test::Mesh& mesh, const test::Rays& rays,
                             const std::vector<rsh_mesh_range>& ranges,
                             const test::TraceOptions& options = {}) {
        const test::DeviceMesh device_mesh(mesh);
        TraceWay way;
        way.options = options;
        way.normals = way.points = true;
        way.ranges = ranges;
        const auto found = trace_hits(device_mesh, rays, way);
        EXPECT_TRUE(test::same_bits(
            found.hits, closest_hits(device_mesh, rays, test::brute_force()), "hits"));
        size_t hits = 0;
        for (size_t i = 0; i < found.hits.size(); ++i) {
            SCOPED_TRACE("hit " + std::to_string(i));
            const uint32_t triangle = found.hits[i].primitive;
            if (triangle == RSH_NO_HIT) {
                EXPECT_EQ(max_norm(found.normals[i]), 0.0f);
                EXPECT_TRUE(is_nowhere(found.points[i]));
                EXPECT_EQ(found.ids[i], RSH_NO_HIT);
                continue;
            }
            ++hits;
            const Double3 error = Double3(found.normals[i]) - normal_of(mesh, triangle);
            EXPECT_LT(max_norm(error), 0x1p-22) << "triangle " << triangle;
            EXPECT_LT(error_of_point(mesh, found.hits[i], found.points[i]), 0x1p-21)
                << "triangle " << triangle;
            EXPECT_EQ(found.ids[i], id_of(ranges, triangle)) << "triangle " << triangle;
        }
        EXPECT_GT(hits, found.hits.size() / 20);
        EXPECT_LT(hits, found.hits.size());
    }

    test::Random random_{63};
    const test::Rays rays_ = test::pinhole_rays(test::small() ? 16 : 70, 40);
};

TEST_F(Describe, FindsNormalsPointsAndMeshes) {
    const test::Mesh soup = test::random_soup(random_, 300);
    expect_descriptions(soup, rays_, {{0, 5, ~0u, 0}});
    expect_descriptions(soup, rays_, {{0, 5, ~0u, 0}, {150, 0xfffffff0u, 0, 0}});
    // Some hold nothing: before the next one, or behind all triangles.
    std::vector<rsh_mesh_range> many;
    for (uint32_t i = 0; i < 97; ++i) many.push_back({i < 2 ? 0 : 4 * (i / 2), 3 * i, ~0u, 0});
    many.push_back({400, 1, ~0u, 0});
    expect_descriptions(soup, rays_, many);
    const test::Mesh torus = test::torus(20, 20);  // with indices
    expect_descriptions(torus, rays_, many);
    expect_descriptions(test::scaled(torus, 0x1p-60f, {}),
                        test::without_intervals(test::scaled(rays_, 0x1p-60f)), many);
    expect_descriptions(test::degenerate_soup(random_, test::small() ? 100 : 600), rays_, many);
}

TEST_F(Describe, FindsThoseOfAllHits) {
    const test::Mesh soup = test::random_soup(random_, 300);
    const test::DeviceMesh mesh(soup);
    TraceWay way;
    way.normals = way.points = true;
    way.ranges = {{0, 5, ~0u, 0}, {100, 6, ~0u, 0}, {200, 7, ~0u, 0}};
    const test::HitLists lists = all_hits(mesh, rays_, test::brute_force());
    const size_t count = lists.hits.size();
    const auto found = trace_lists(mesh, rays_, count + 10, way).answers;
    ASSERT_GT(count, rays_.rays.size() / 4);
    for (size_t i = 0; i < count; ++i) {
        SCOPED_TRACE("hit " + std::to_string(i));
        const uint32_t triangle = lists.hits[i].primitive;
        EXPECT_EQ(found.hits[i].primitive, triangle);
        EXPECT_LT(max_norm(Double3(found.normals[i]) - normal_of(soup, triangle)), 0x1p-22);
        EXPECT_LT(error_of_point(soup, found.hits[i], found.points[i]), 0x1p-21);
        EXPECT_EQ(found.ids[i], 5 + triangle / 100);
    }
    const uint32_t untouched = test::Buffer<uint32_t>(1).read()[0];
    for (size_t i = count; i < count + 10; ++i) EXPECT_EQ(found.ids[i], untouched) << i;
    const auto none = trace_lists(mesh, rays_, count - 1, way).answers;
    for (size_t i = 0; i < none.ids.size(); ++i) EXPECT_EQ(none.ids[i], untouched) << i;
}

// Whose edges and products floats round.
TEST_F(Describe, FindsTheNormalsOfNeedles) {
    test::Mesh needles;
    test::Rays rays;
    for (int i = 0; i < 300; ++i) {
        const test::Float3 a = random_.in_cube(), b = random_.in_cube();
        const test::Float3 c = a + 0.3f * (b - a) + random_.in_cube(1e-4f);
        needles.add(a, b, c);
        const test::Float3 centre = (1 / 3.0f) * (a + b + c), from = random_.in_cube(3);
        rays.rays.push_back(test::make_ray(from, centre - from));
    }
    rays.width = 300;
    for (const cl_uint width : {0u, 1u, 4u}) {
        SCOPED_TRACE("width " + std::to_string(width));
        const test::OwnContext context(width);
        test::TraceOptions options = test::brute_force();
        options.context = context.get();
        expect_descriptions(needles, rays, {{0, 5, ~0u, 0}}, options);
    }
}

// A buffer can hold anything.
TEST_F(Describe, TakesRangesThatDoNotAscend) {
    const test::DeviceMesh mesh(test::random_soup(random_, 300));
    TraceWay way;
    for (uint32_t i = 0; i < 53; ++i)
        way.ranges.push_back({uint32_t(random_.bits()), i, ~0u, 0});
    const auto found = trace_hits(mesh, rays_, way);
    for (size_t i = 0; i < found.hits.size(); ++i)
        if (found.hits[i].primitive != RSH_NO_HIT) {
            EXPECT_LT(found.ids[i], 53u) << "hit " << i;
        }
}

// Bounds of something else: nothing is hit, and what the hits hold then leads nowhere.
TEST_F(Describe, ReadsNothingWhereHitsAreNone) {
    const test::DeviceMesh mesh(test::random_soup(random_, 300));
    const test::Buffer<uint8_t> bounds(1u << 16);
    const test::Buffer<rsh_ray> rays(rays_.rays);
    const test::Buffer<rsh_hit> hits(rays_.rays.size());
    const test::Buffer<test::Float3> normals(rays_.rays.size()), points(rays_.rays.size());
    rsh_trace_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = mesh.geometry();
    desc.bounds = bounds.get();
    desc.rays = rays.get();
    desc.width = rays_.width;
    desc.height = rays_.height;
    desc.engine = RSH_ENGINE_TILES;
    desc.hits = hits.get();
    desc.normals = normals.get();
    desc.points = points.get();
    const rsh_context rsh = test::device().rsh;
    RSH_CHECK(rsh_trace(rsh, test::device().queue(), &desc, 0, nullptr, nullptr));
    EXPECT_EQ(rsh_device_status(rsh, test::device().queue()), RSH_INVALID_VALUE);
    for (const test::Float3& normal : normals.read()) EXPECT_EQ(max_norm(normal), 0.0f);
    for (const test::Float3& point : points.read()) EXPECT_TRUE(is_nowhere(point));
}

}  // namespace
