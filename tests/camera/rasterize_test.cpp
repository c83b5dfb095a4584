// rasterize_test.cpp - the rasterizer finds what tracing the rays that it wrote finds, bit for
// bit, for any size, camera, mesh and scratch budget; and those rays are the camera's.
#include <gtest/gtest.h>

#include <memory>

#include "support/compare.hpp"
#include "support/scene.hpp"
#include "support/ways.hpp"

namespace {

using test::Buffer;
using test::Float3;
using test::Mesh;

struct View {
    rsh_camera camera;
    uint32_t width, height;
};

struct Raster {
    test::Rays rays;
    std::vector<rsh_hit> hits;
};

View view(uint32_t width, uint32_t height, Float3 eye = {0.3f, 0.4f, 3}, Float3 at = {}) {
    return {test::look_at(eye, at, width, height), width, height};
}

Raster rasterize(const test::DeviceMesh& mesh, const View& v, size_t budget, bool own_scratch,
                 rsh_context context = test::device().rsh) {
    const size_t pixels = size_t(v.width) * v.height;
    const Buffer<rsh_ray> rays(pixels);
    const Buffer<rsh_hit> hits(pixels);
    rsh_rasterize_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = mesh.geometry();
    desc.camera = v.camera;
    desc.width = v.width;
    desc.height = v.height;
    desc.rays = rays.get();
    desc.hits = hits.get();
    desc.scratch_budget = budget;
    std::unique_ptr<test::Bytes> scratch;
    if (own_scratch) {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_rasterize_query(context, &desc, &sizes));
        scratch = std::make_unique<test::Bytes>(sizes.scratch_bytes);
        desc.scratch = scratch->get();
    }
    RSH_CHECK(rsh_rasterize(context, test::device().queue(), &desc, 0, nullptr, nullptr));
    Raster made = {{rays.read(), v.width, v.height}, hits.read()};
    EXPECT_TRUE(rays.guards_intact());
    EXPECT_TRUE(hits.guards_intact());
    if (scratch) {
        EXPECT_TRUE(scratch->guards_intact());
    }
    return made;
}

// The header's formula, in double.
void expect_rays_of(const View& v, const test::Rays& rays) {
    const auto vec = [](const rsh_float4& f) { return test::Double3(f.s[0], f.s[1], f.s[2]); };
    for (uint32_t y = 0; y < v.height; ++y)
        for (uint32_t x = 0; x < v.width; ++x) {
            const rsh_ray& ray = rays.rays[size_t(y) * v.width + x];
            const double right = (x + 0.5) / v.width * 2 - 1, up = 1 - (y + 0.5) / v.height * 2;
            const auto d = normalize(vec(v.camera.forward) + right * vec(v.camera.right) +
                                     up * vec(v.camera.up));
            ASSERT_LT(max_norm(test::Double3(test::direction(ray)) - d), 1e-6)
                << "pixel " << x << ", " << y;
            ASSERT_EQ(max_norm(vec(v.camera.eye) - test::Double3(test::origin(ray))), 0);
            ASSERT_EQ(ray.origin_tmin.s[3], v.camera.eye.s[3]);
            const float far = v.camera.forward.s[3];
            ASSERT_EQ(ray.direction_tmax.s[3], far == 0 ? INFINITY : far);
        }
}

void expect_same_as_tracing(const Mesh& mesh, const View& v, size_t budget = 0,
                            bool own_scratch = false) {
    SCOPED_TRACE(std::to_string(v.width) + " x " + std::to_string(v.height) + ", budget " +
                 std::to_string(budget));
    const test::DeviceMesh on_device(mesh);
    const Raster raster = rasterize(on_device, v, budget, own_scratch);
    expect_rays_of(v, raster.rays);
    for (const test::TraceOptions& options : test::brute_force_and_all_ways())
        EXPECT_TRUE(
            test::same_bits(raster.hits, closest_hits(on_device, raster.rays, options), "hits"))
            << "against " << name_of(options);
}

uint32_t side(uint32_t full) {
    return test::small() ? std::max(5u, full / 10) : full;
}

TEST(Rasterize, EqualsTracingInImagesOfAnyShape) {
    test::Random random(20);
    const Mesh mesh = test::random_soup(random, test::small() ? 50 : 500, 0.4f);
    const uint32_t shapes[][2] = {{1, 1},   {1, 61},  {67, 1},  {2, 2},
                                  {16, 16}, {17, 15}, {31, 33}, {64, 48}};
    for (const auto& shape : shapes) {
        if (test::small() && shape[0] * shape[1] > 300) continue;
        expect_same_as_tracing(mesh, view(shape[0], shape[1]));
    }
}

// As on a GPU.
TEST(Rasterize, FindsTheSameWhereAWorkGroupIsATile) {
    test::Random random(27);
    const Mesh mesh = test::random_soup(random, 500, 0.4f);
    const test::DeviceMesh on_device(mesh);
    const test::OwnContext of_one_lane(1);
    for (const View& v : {view(3, 2), view(61, 47)}) {
        const Raster usual = rasterize(on_device, v, 0, false);
        const Raster raster = rasterize(on_device, v, 0, false, of_one_lane.get());
        EXPECT_TRUE(test::same_bits(raster.rays.rays, usual.rays.rays, "rays"));
        EXPECT_TRUE(test::same_bits(raster.hits, usual.hits, "hits"));
    }
}

TEST(Rasterize, EqualsTracingInLargeImages) {
    test::Random random(21);
    const Mesh mesh = test::random_soup(random, test::small() ? 20 : 150, 0.5f);
    expect_same_as_tracing(mesh, view(side(640), side(480)));
    expect_same_as_tracing(mesh, view(side(1021), side(769)));
}

TEST(Rasterize, EqualsTracingForTrianglesAcrossTheNearPlaneAndBehind) {
    test::Random random(22);
    const Mesh mesh = test::random_soup(random, 300, 0.8f);
    expect_same_as_tracing(mesh, view(side(80), side(60), {0, 0, 0}, {0.3f, 0.1f, -1}));
    View deep = view(side(80), side(60), {0, 0, 0.9f}, {0, 0, -1});
    deep.camera.eye.s[3] = 0.6f;
    deep.camera.forward.s[3] = 1.4f;
    expect_same_as_tracing(mesh, deep);
}

TEST(Rasterize, EqualsTracingForHugeAndSubPixelTriangles) {
    test::Random random(23);
    expect_same_as_tracing(test::large_next_to_tiny(random, test::small() ? 200 : 3000),
                           view(side(80), side(60)));
    expect_same_as_tracing(test::scaled(test::sphere(64, 41), 0.02f), view(side(80), side(60)));
}

TEST(Rasterize, EqualsTracingForClosedMeshesAndExactEdges) {
    expect_same_as_tracing(test::torus(48, 32), view(side(97), side(89)));
    // The grid's vertices fall on pixel centres.
    rsh_camera camera = {};
    camera.eye = {{0, 0, 1, 0}};
    camera.forward = {{0, 0, -1, 0}};
    camera.right = {{1.0625f, 0, 0, 0}};
    camera.up = {{0, 1.0625f, 0, 0}};
    expect_same_as_tracing(test::grid(16), {camera, 17, 17});
    expect_same_as_tracing(test::grid(16), {camera, 34, 17});
}

TEST(Rasterize, EqualsTracingForDegenerateTriangles) {
    test::Random random(24);
    expect_same_as_tracing(test::degenerate_soup(random, test::small() ? 60 : 600),
                           view(side(80), side(60)));
}

TEST(Rasterize, EqualsTracingWithEveryScratchBudget) {
    test::Random random(25);
    const Mesh mesh = test::random_soup(random, test::small() ? 100 : 2000, 0.5f);
    for (const size_t budget : {size_t(1), size_t(4096), size_t(65536), size_t(1) << 20}) {
        expect_same_as_tracing(mesh, view(side(80), side(64)), budget);
        expect_same_as_tracing(mesh, view(side(80), side(64)), budget, true);
    }
}

TEST(Rasterize, EqualsTracingAtExtremeScales) {
    test::Random random(26);
    const Mesh mesh = test::random_soup(random, 100, 0.5f);
    for (const float scale : {1e-15f, 1e-6f, 1e6f, 1e15f}) {
        const Float3 eye = scale * Float3(0.3f, 0.4f, 3);
        View v = view(side(64), side(48), eye);
        v.camera.eye.s[3] = 0;
        expect_same_as_tracing(test::scaled(mesh, scale), v);
    }
}

TEST(Rasterize, FindsNothingWithoutTriangles) {
    const View v = view(33, 17);
    const Raster raster = rasterize(test::DeviceMesh(Mesh()), v, 0, false);
    expect_rays_of(v, raster.rays);
    for (const rsh_hit& hit : raster.hits) ASSERT_EQ(hit.primitive, RSH_NO_HIT);
}

}  // namespace
