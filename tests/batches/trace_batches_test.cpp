// trace_batches_test.cpp - rays through scenes that come in batches, and batches that are refused or stopped.
#include <gtest/gtest.h>

#include "batches/scene_source.hpp"
#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"
#include "support/ways.hpp"

namespace {

using test::Buffer;
using test::DeviceMesh;
using test::Rays;
using test::SceneSource;

test::Scene scene_of(const test::Mesh& mesh) {
    test::Scene scene;
    scene.mesh = mesh;
    return scene;
}

class TraceBatches : public ::testing::Test {
protected:
    TraceBatches() {
        desc_.struct_size = sizeof desc_;
        desc_.width = rays_.width;
        desc_.height = rays_.height;
        desc_.rays = ray_buffer_.get();
        desc_.hits = hits_.get();
        desc_.occlusion = occlusion_.get();
    }

    rsh_status trace(const SceneSource& source) {
        desc_.batches = source.get();
        const rsh_status status =
            rsh_trace(test::device().rsh, test::device().queue(), &desc_, 0, nullptr, nullptr);
        test::device().queue.finish();
        return status;
    }

    void expect_refused(const rsh_batch_source& source, const std::string& error) {
        desc_.batches = &source;
        EXPECT_EQ(
            rsh_trace(test::device().rsh, test::device().queue(), &desc_, 0, nullptr, nullptr),
            RSH_INVALID_VALUE);
        EXPECT_NE(std::string(rsh_last_error()).find(error), std::string::npos)
            << rsh_last_error();
        test::device().queue.finish();
    }

    test::Random random_{61};
    const test::Scene scene_ = scene_of(test::random_soup(random_, 700, 0.4f));
    const DeviceMesh whole_{scene_.mesh};
    const Rays rays_ = test::pinhole_rays(test::small() ? 17 : 61, 43);
    const Buffer<rsh_ray> ray_buffer_{rays_.rays};
    const Buffer<rsh_hit> hits_{rays_.rays.size()};
    const Buffer<uint32_t> occlusion_{rays_.rays.size()};
    rsh_trace_desc desc_ = {};
};

TEST_F(TraceBatches, FindsWhatOneGeometryHolds) {
    const auto hits = closest_hits(whole_, rays_, test::brute_force());
    const auto hidden = test::occlusion(whole_, rays_, std::vector<uint32_t>(rays_.rays.size()),
                                        0, test::brute_force());
    for (const test::TraceOptions& way : test::brute_force_and_all_ways())
        for (const uint32_t most : {0u, 300u, 40u}) {
            SCOPED_TRACE(name_of(way) + ", batches of at most " + std::to_string(most));
            desc_.engine = way.engine;
            desc_.query = RSH_QUERY_CLOSEST;
            RSH_CHECK(trace(SceneSource(scene_, most)));
            EXPECT_TRUE(test::same_bits(hits_.read(), hits, "hits"));
            desc_.query = RSH_QUERY_ANY;
            occlusion_.write(std::vector<uint32_t>(rays_.rays.size()));
            RSH_CHECK(trace(SceneSource(scene_, most)));
            EXPECT_TRUE(test::same_bits(occlusion_.read(), hidden, "masks"));
        }
}

// Rays behind the count are neither read nor answered; nodes that are seen from t = 1 take another way.
TEST_F(TraceBatches, TakesListsAndRaysThatConverge) {
    const Rays rays =
        test::converging_rays(random_, test::small() ? 100 : 900, 1, {0.2f, 0.1f, 0.3f});
    const uint32_t count = rays.width - 37;
    const Buffer<rsh_ray> ray_buffer(rays.rays);
    const Buffer<uint32_t> list_count(std::vector<uint32_t>{count});
    const std::vector<rsh_hit> before(rays.rays.size(), rsh_hit{7, 7, 7, 7});
    auto expected = closest_hits(whole_, rays, test::brute_force());
    std::copy(before.begin() + count, before.end(), expected.begin() + count);
    desc_.rays = ray_buffer.get();
    desc_.width = rays.width;
    desc_.height = 1;
    desc_.list_count = list_count.get();
    for (const test::TraceOptions& way : test::brute_force_and_all_ways())
        for (const cl_uint converging : {0u, 1u}) {
            const Buffer<rsh_hit> hits(before);
            desc_.hits = hits.get();
            desc_.engine = way.engine;
            desc_.converging = converging;
            RSH_CHECK(trace(SceneSource(scene_, 60)));
            EXPECT_TRUE(test::same_bits(hits.read(), expected, "hits"))
                << name_of(way) << ", converging " << converging;
        }
}

// A batch may have fewer triangles than there is room for: no part of scratch grows then.
TEST_F(TraceBatches, OfFewerTrianglesTakeNoMoreScratch) {
    rsh_bound_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.shape = RSH_SHAPE_BOX;
    size_t before = 0;
    for (cl_uint triangles = 1; triangles < 3000000; triangles += 1 + triangles / 300) {
        desc.geometry.triangle_count = triangles;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_bound_query(test::device().rsh, &desc, &sizes));
        ASSERT_GE(sizes.scratch_bytes, before) << triangles << " triangles";
        before = sizes.scratch_bytes;
    }
}

TEST_F(TraceBatches, OfNoTrianglesFindsNothing) {
    const test::Scene empty;
    RSH_CHECK(trace(SceneSource(empty, 0)));
    for (const rsh_hit& hit : hits_.read()) EXPECT_EQ(hit.primitive, RSH_NO_HIT);
}

// What was found before is the answer of the batches before.
TEST_F(TraceBatches, ThatStopsHasTheHitsOfTheBatchesBefore) {
    for (const uint32_t batches : {0u, 1u, 3u}) {
        SceneSource source(scene_, 100);
        source.stop_after(batches);
        EXPECT_EQ(trace(source), RSH_CANCELLED);
        EXPECT_NE(std::string(rsh_last_error()).find("asked to stop"), std::string::npos);
        test::Mesh part = scene_.mesh;
        part.vertices.resize(3 * source.triangles());
        EXPECT_TRUE(test::same_bits(
            hits_.read(), closest_hits(DeviceMesh(part), rays_, test::brute_force()), "hits"))
            << batches << " batches";
    }
}

TEST_F(TraceBatches, AsksBeforeEachBatchWhetherToGoOn) {
    struct Asked {
        std::vector<cl_uint> batches;
        size_t most;
    } asked = {{}, 1000};
    desc_.progress_user = &asked;
    desc_.progress = [](cl_uint batch, cl_uint count, void* user) {
        Asked& own = *static_cast<Asked*>(user);
        EXPECT_EQ(count, 0u);
        own.batches.push_back(batch);
        return own.batches.size() > own.most ? 1 : 0;
    };
    const SceneSource source(scene_, 100);
    RSH_CHECK(trace(source));
    ASSERT_EQ(asked.batches.size(), source.batches());
    for (size_t i = 0; i < asked.batches.size(); ++i) EXPECT_EQ(asked.batches[i], i);
    asked = {{}, 2};
    const SceneSource stopped(scene_, 100);
    EXPECT_EQ(trace(stopped), RSH_CANCELLED);
    EXPECT_EQ(stopped.batches(), 2u);
}

TEST_F(TraceBatches, WithALittleMemoryComesInMoreBatches) {
    desc_.batch_budget = 1;
    const SceneSource none(scene_, 0);
    expect_refused(*none.get(), "batch_budget: is 1, must be 0 or at least ");
    const std::string error = rsh_last_error();
    desc_.batch_budget = std::stoull(error.substr(error.rfind(' ')));
    RSH_CHECK(trace(none));
    --desc_.batch_budget;
    expect_refused(*none.get(), "batch_budget: is ");
}

TEST_F(TraceBatches, RefusesWhatASourceMayNotBe) {
    const SceneSource good(scene_, 0);
    rsh_batch_source source = *good.get();
    source.fill = nullptr;
    expect_refused(source, "batches.fill: is NULL, must not be");
    source = *good.get();
    source.triangle_count = 0xf0000000u;
    expect_refused(source, "batches.triangle_count: is 4026531840, must be below 4026531840");
    source = *good.get();
    source.attributes = 16;
    expect_refused(source, "batches.attributes: is 16, must be made of RSH_BATCH_ bits");
    source = *good.get();
    source.batch_triangles = 1u << 28;
    expect_refused(source, "batches.batch_triangles: is 268435456, must be below 268435456");
    source = *good.get();
    source.struct_size = 1;
    expect_refused(source, "batches.struct_size: is 1, must be");
}

TEST_F(TraceBatches, RefusesWhatDoesNotGoTogether) {
    const SceneSource good(scene_, 0);
    const rsh_trace_desc before = desc_;
    desc_.geometry = whole_.geometry();
    expect_refused(*good.get(), "geometry.triangle_count: is 700, must be 0 with batches");
    desc_ = before;
    desc_.query = RSH_QUERY_COUNT;
    expect_refused(*good.get(), "query: is 2, must be RSH_QUERY_CLOSEST");
    desc_ = before;
    desc_.continued = 1;
    expect_refused(*good.get(), "continued: is 1, must be 0 with batches");
    desc_ = before;
    desc_.first_triangle = 3;
    expect_refused(*good.get(), "first_triangle: is 3, must be 0 with batches");
    desc_ = before;
    desc_.normals = hits_.get();
    expect_refused(*good.get(), "normals: is set, must be NULL with batches");
    desc_ = before;
    desc_.geometry.indices = occlusion_.get();
    expect_refused(*good.get(), "geometry.indices: is set, must be NULL with batches");
    desc_ = before;
    desc_.skip = occlusion_.get();
    expect_refused(*good.get(), "skip_corners: is NULL");
}

// What a source answers is looked at before it is used.
TEST_F(TraceBatches, RefusesABatchThatIsNone) {
    const SceneSource good(scene_, 200);
    rsh_batch_source source = *good.get();
    source.user = nullptr;
    source.fill = [](rsh_batch* batch, void*) {
        batch->triangle_count = 0;
        return 0;
    };
    expect_refused(source, "batch.triangle_count: is 0, must be 1 .. 200 from triangle 0 on");
    source.fill = [](rsh_batch* batch, void*) {
        batch->triangle_count = 201;
        return 0;
    };
    expect_refused(source, "batch.triangle_count: is 201, must be 1 .. 200");
    source.fill = [](rsh_batch* batch, void*) {
        batch->triangle_count = 1;
        batch->vertex_count = batch->vertex_capacity + 1;
        return 0;
    };
    expect_refused(source, "batch.vertex_count: is 601, must be at most 600");
}

// An exception does not cross the interface, and nothing that a device still reads is lost.
TEST_F(TraceBatches, SurvivesASourceThatThrows) {
    const SceneSource good(scene_, 200);
    rsh_batch_source source = *good.get();
    source.fill = [](rsh_batch*, void*) -> int { throw 1; };
    desc_.batches = &source;
    EXPECT_EQ(
        rsh_trace(test::device().rsh, test::device().queue(), &desc_, 0, nullptr, nullptr),
        RSH_INTERNAL_ERROR);
    test::device().queue.finish();
    RSH_CHECK(trace(good));
}

}  // namespace
