// limits_test.cpp - the largest values that a descriptor may hold: queries refuse what calls
// refuse, and what they accept fits the counters of the kernels. Also the structs' sizes.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "api/struct_size.hpp"
#include "api/valid_calls.hpp"
#include "support/ways.hpp"

namespace {

using test::device;

// The queries by descriptor type, so that one template tests all of them.
rsh_status query(const rsh_rasterize_desc* d, rsh_sizes* s) {
    return rsh_rasterize_query(device().rsh, d, s);
}
rsh_status query(const rsh_bound_desc* d, rsh_sizes* s) {
    return rsh_bound_query(device().rsh, d, s);
}
rsh_status query(const rsh_build_desc* d, rsh_sizes* s) {
    return rsh_build_query(device().rsh, d, s);
}
rsh_status query(const rsh_traverse_desc* d, rsh_sizes* s) {
    return rsh_traverse_query(device().rsh, d, s);
}
rsh_status query(const rsh_trace_desc* d, rsh_sizes* s) {
    return rsh_trace_query(device().rsh, d, s);
}
rsh_status query(const rsh_frame_desc* d, rsh_sizes* s) {
    return rsh_frame_query(device().rsh, d, s);
}
rsh_status query(const rsh_reduce_desc* d, rsh_sizes* s) {
    return rsh_reduce_query(device().rsh, d, s);
}

template <class Desc>
rsh_sizes sizes_of(const Desc& desc) {
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    RSH_CHECK(query(&desc, &sizes));
    return sizes;
}

template <class Desc>
void refuses(Desc desc, const std::string& field, const std::function<void(Desc&)>& break_it) {
    break_it(desc);
    rsh_sizes sizes = {sizeof sizes, 11, 22};
    EXPECT_EQ(query(&desc, &sizes), RSH_INVALID_VALUE) << field;
    EXPECT_NE(std::string(rsh_last_error()).find(field + ": is "), std::string::npos)
        << field << " is not in: " << rsh_last_error();
    EXPECT_EQ(sizes.output_bytes, 11u);
    EXPECT_EQ(sizes.scratch_bytes, 22u);
}

class Queries : public ::testing::Test {
protected:
    test::ValidCalls valid_;
};

// Such sides once wrote behind the table of levels; so many bounces never came to an end.
TEST_F(Queries, OfFramesRefuseWhatFramesRefuse) {
    using Desc = rsh_frame_desc;
    const Desc desc = valid_.frame();
    refuses<Desc>(desc, "width", [](Desc& d) { d.width = d.height = 1u << 20; });
    refuses<Desc>(desc, "height", [](Desc& d) { d.height = 0; });
    refuses<Desc>(desc, "bounces", [](Desc& d) { d.bounces = 0xffffffffu; });
    refuses<Desc>(desc, "min_weight", [](Desc& d) { d.min_weight = NAN; });
    refuses<Desc>(desc, "engine", [](Desc& d) { d.engine = 77; });
    refuses<Desc>(desc, "strategy", [](Desc& d) { d.strategy = 77; });
    refuses<Desc>(desc, "budget", [](Desc& d) { d.budget = RSH_MIN_BUDGET - 1; });
    refuses<Desc>(desc, "camera.eye", [](Desc& d) { d.camera.eye.s[0] = NAN; });
    rsh_scene scene = *desc.scene;
    scene.geometry.triangle_count = 1u << 28;
    refuses<Desc>(desc, "geometry.triangle_count", [&](Desc& d) { d.scene = &scene; });
    scene.struct_size = 8;
    refuses<Desc>(desc, "scene.struct_size", [&](Desc& d) { d.scene = &scene; });
}

TEST_F(Queries, OfTraversalsRefuseWhatTraversalsRefuse) {
    using Desc = rsh_traverse_desc;
    const Desc desc = valid_.traverse();
    refuses<Desc>(desc, "geometry.triangle_count",
                  [](Desc& d) { d.geometry.triangle_count = 1u << 28; });
    refuses<Desc>(desc, "width", [](Desc& d) { d.width = d.height = 1u << 20; });
    refuses<Desc>(desc, "budget", [](Desc& d) { d.budget = 1; });
    refuses<Desc>(desc, "engine", [](Desc& d) { d.engine = 77; });
    refuses<Desc>(desc, "strategy", [](Desc& d) { d.strategy = 77; });
    refuses<Desc>(desc, "query", [](Desc& d) { d.query = 4; });
    refuses<Desc>(desc, "hit_capacity",
                  [](Desc& d) { d.query = RSH_QUERY_ALL, d.hit_capacity = (1ull << 31) + 1; });
    refuses<Desc>(desc, "occlusion_bit",
                  [](Desc& d) { d.query = RSH_QUERY_ANY, d.occlusion_bit = 32; });
}

TEST_F(Queries, OfRasterizeBoundAndBuildRefuseWhatTheCallsRefuse) {
    using Rasterize = rsh_rasterize_desc;
    for (const cl_uint side : {0u, 16385u, 0xffffffffu}) {
        refuses<Rasterize>(valid_.rasterize(), "width", [=](auto& d) { d.width = side; });
        refuses<Rasterize>(valid_.rasterize(), "height", [=](auto& d) { d.height = side; });
    }
    refuses<Rasterize>(valid_.rasterize(), "camera.up",
                       [](auto& d) { d.camera.up.s[1] = NAN; });
    refuses<Rasterize>(valid_.rasterize(), "geometry.vertex_stride",
                       [](auto& d) { d.geometry.vertex_stride = 8; });
    refuses<rsh_bound_desc>(valid_.bound(), "geometry.triangle_count",
                            [](auto& d) { d.geometry.triangle_count = 1u << 28; });
    refuses<rsh_build_desc>(valid_.build(), "width", [](auto& d) { d.width = 16385; });
    refuses<rsh_build_desc>(valid_.build(), "converging", [](auto& d) { d.converging = 2; });
    refuses<rsh_bound_desc>(valid_.bound(), "mode", [](auto& d) { d.mode = 3; });
    refuses<rsh_frame_desc>(valid_.frame(), "mode", [](auto& d) { d.mode = 3; });
}

TEST_F(Queries, OfReductionsRefuseWhatReductionsRefuse) {
    using Desc = rsh_reduce_desc;
    const Desc desc = valid_.reduce();
    refuses<Desc>(desc, "element_bytes", [](Desc& d) { d.element_bytes = 20; });
    refuses<Desc>(desc, "keep", [](Desc& d) { d.keep = 3; });
    refuses<Desc>(desc, "strategy", [](Desc& d) { d.strategy = 77; });
    refuses<Desc>(desc, "count", [](Desc& d) { d.count = (1u << 31) + 1; });
}

template <class Desc>
void expect_same_sizes(const Desc& with, const Desc& without) {
    EXPECT_EQ(sizes_of(with).output_bytes, sizes_of(without).output_bytes);
    EXPECT_EQ(sizes_of(with).scratch_bytes, sizes_of(without).scratch_bytes);
}

TEST_F(Queries, ReadNoBuffers) {
    rsh_scene scene = *valid_.frame().scene;
    scene.normals = scene.texcoords = scene.material_ids = scene.materials = scene.lights =
        scene.textures = scene.texels = scene.geometry.vertices = nullptr;
    rsh_frame_desc frame = valid_.frame();
    frame.bounces = 2;
    rsh_frame_desc bare = frame;
    bare.scene = &scene;
    bare.colour = nullptr;
    expect_same_sizes(frame, bare);

    rsh_traverse_desc traverse = valid_.traverse();
    traverse.engine = RSH_ENGINE_PAPER_FAITHFUL;
    traverse.shape = RSH_SHAPE_CONE;
    rsh_traverse_desc bare_traverse = traverse;
    bare_traverse.rays = bare_traverse.hits = bare_traverse.geometry.vertices = nullptr;
    expect_same_sizes(traverse, bare_traverse);

    rsh_trace_desc trace = valid_.trace();
    trace.rays = nullptr;
    rsh_trace_desc bare_trace = trace;
    bare_trace.hits = bare_trace.geometry.vertices = nullptr;
    trace.origins.buffer = trace.directions.buffer = valid_.rays.get();
    trace.normals = trace.points = trace.geometry_ids = valid_.colour.get();
    expect_same_sizes(trace, bare_trace);

    rsh_reduce_desc bare_reduce = valid_.reduce();
    bare_reduce.input = bare_reduce.flags = bare_reduce.output = bare_reduce.output_count =
        nullptr;
    expect_same_sizes(valid_.reduce(), bare_reduce);
}

// The largest values allowed: tables of levels hold them, and sizes do not wrap.
TEST_F(Queries, AnswerAtTheLimits) {
    rsh_frame_desc frame = valid_.frame();
    frame.width = frame.height = 16384;
    frame.bounces = RSH_MAX_LEVELS;
    const size_t pixels = size_t{1} << 28;
    if (sizeof(size_t) < 8) GTEST_SKIP() << "such sizes need more than 32 bits";
    EXPECT_EQ(sizes_of(frame).output_bytes, 16 * pixels);
    const size_t in_strips = sizes_of(frame).scratch_bytes;
    frame.budget = size_t{1} << 45;
    EXPECT_GT(sizes_of(frame).scratch_bytes, (RSH_MAX_LEVELS + 1) * 48 * pixels);
    EXPECT_LT(in_strips, sizes_of(frame).scratch_bytes);
    rsh_reduce_desc reduce = valid_.reduce();
    reduce.count = 1u << 31;
    reduce.element_bytes = 16;
    EXPECT_EQ(sizes_of(reduce).output_bytes, size_t{1} << 35);
}

// 2^36 bytes and more once made a limit whose four-fold wrapped in 32 bits: every hit was lost.
TEST(Limits, OfTheBudgetKeepACountOfCandidatesIn32Bits) {
    if (sizeof(size_t) < 8) GTEST_SKIP() << "no such budget with 32-bit sizes";
    const test::ValidCalls valid;
    rsh_traverse_desc desc = valid.traverse();
    desc.engine = RSH_ENGINE_PAPER_FAITHFUL;
    desc.shape = RSH_SHAPE_CONE;
    desc.geometry.triangle_count = (1u << 28) - 1;
    desc.width = desc.height = 16384;
    size_t bytes[3] = {};
    for (int i = 0; i < 3; ++i) {
        desc.budget = size_t{1} << (34 + i);
        bytes[i] = sizes_of(desc).scratch_bytes;
    }
    EXPECT_LT(bytes[0], bytes[1]);
    EXPECT_EQ(bytes[1], bytes[2]);
}

// What programs built for version 0.1 pass on machines with 64-bit pointers; never to change.
TEST_F(Queries, TakeTheStructsOfVersion0_1) {
    if (sizeof(void*) != 8) GTEST_SKIP() << "sizes of other machines";
    const auto takes = [](auto desc, size_t bytes) {
        desc.struct_size = bytes;
        rsh_sizes sizes = {};
        sizes.struct_size = 24;
        EXPECT_EQ(query(&desc, &sizes), RSH_SUCCESS) << rsh_last_error();
        EXPECT_EQ(sizes.struct_size, 24u);
    };
    takes(valid_.rasterize(), 256);
    takes(valid_.bound(), 144);
    takes(valid_.build(), 48);
    takes(valid_.traverse(), 216);
    takes(valid_.frame(), 208);
    takes(valid_.reduce(), 72);
    EXPECT_EQ(rsh::FirstVersion<rsh_audit_desc>::bytes, 168u);
    EXPECT_EQ(sizeof(rsh_geometry), 104u);
    EXPECT_EQ(sizeof(rsh_camera), 96u);
    rsh_scene scene = valid_.scene.desc;
    scene.struct_size = 256;
    EXPECT_EQ(
        rsh_find_features(&scene, valid_.host.materials.data(), valid_.host.lights.data()),
        RSH_SUCCESS);
    EXPECT_EQ(scene.struct_size, 256u);
    rsh_statistics statistics = {};
    statistics.struct_size = 712;
    EXPECT_EQ(rsh_get_statistics(device().rsh, &statistics), RSH_SUCCESS);
    EXPECT_EQ(statistics.struct_size, 712u);
}

TEST_F(Queries, OfFeaturesRefuseStructSizes) {
    for (const size_t size :
         {size_t{0}, offsetof(rsh_scene, features), sizeof(rsh_scene) + 8}) {
        rsh_scene scene = valid_.scene.desc;
        scene.struct_size = size;
        scene.features = 77;
        EXPECT_EQ(
            rsh_find_features(&scene, valid_.host.materials.data(), valid_.host.lights.data()),
            RSH_INVALID_VALUE);
        EXPECT_NE(std::string(rsh_last_error()).find("scene.struct_size: is "),
                  std::string::npos)
            << rsh_last_error();
        EXPECT_EQ(scene.features, 77u);
    }
}

// A frame has room for lists of up to so many rays, and learns on its way how long they are.
TEST_F(Queries, AskNoMoreForShorterLists) {
    for (const test::TraceOptions& way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        rsh_build_desc build = valid_.build();
        rsh_traverse_desc traverse = valid_.traverse();
        build.shape = traverse.shape = way.bound;
        traverse.engine = way.engine;
        rsh_sizes made = {}, walked = {};
        for (cl_uint rays = 1; rays < 1u << 24; rays += 1 + rays / 7) {
            build.width = traverse.width = rays;
            build.height = traverse.height = 1;
            const rsh_sizes b = sizes_of(build), t = sizes_of(traverse);
            ASSERT_GE(b.output_bytes, made.output_bytes) << rays << " rays";
            ASSERT_GE(b.scratch_bytes, made.scratch_bytes) << rays << " rays";
            ASSERT_GE(t.scratch_bytes, walked.scratch_bytes) << rays << " rays";
            made = b;
            walked = t;
        }
    }
}

}  // namespace
