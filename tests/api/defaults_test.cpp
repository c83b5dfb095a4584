// defaults_test.cpp - what a caller gets who chooses nothing: the engine and the shape that suit the
// device, the same in every call, so that the calls fit together. Holds on any device; ctest also
// runs it on one that says that it is a GPU (support/layers/gpu.cpp).
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/kept_frames.hpp"
#include "support/ways.hpp"

namespace {

bool is_cpu() {
    return (test::device().device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
}

cl_uint default_engine() {
    cl_uint engine = RSH_ENGINE_DEFAULT;
    RSH_CHECK(rsh_default_engine(test::device().rsh, &engine));
    return engine;
}

template <class Query, class Desc>
rsh_sizes sizes_of(Query query, rsh_context context, Desc desc) {
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    desc.struct_size = sizeof desc;
    RSH_CHECK(query(context, &desc, &sizes));
    return sizes;
}

TEST(Defaults, AreTheEngineThatSuitsTheDevice) {
    EXPECT_EQ(default_engine(),
              cl_uint{is_cpu() ? RSH_ENGINE_TILES : RSH_ENGINE_PAPER_FAITHFUL});
    cl_uint engine = 77;
    EXPECT_EQ(rsh_default_engine(nullptr, &engine), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_default_engine(test::device().rsh, nullptr), RSH_INVALID_VALUE);
    EXPECT_EQ(engine, 77u);
}

TEST(Defaults, AreCalledAuto) {
    cl_uint engine = 77;
    EXPECT_STREQ(rsh_engine_name(RSH_ENGINE_DEFAULT), "auto");
    EXPECT_EQ(rsh_engine_from_name("auto", &engine), RSH_SUCCESS);
    EXPECT_EQ(engine, cl_uint{RSH_ENGINE_DEFAULT});
    EXPECT_EQ(rsh_engine_shape(RSH_ENGINE_DEFAULT), cl_uint{RSH_SHAPE_DEFAULT});
}

TEST(Defaults, AreTheShapeOfTheDefaultEngine) {
    const rsh_context context = test::device().rsh;
    rsh_bound_desc bound = {};
    bound.geometry.triangle_count = 1000;
    rsh_build_desc build = {};
    build.width = build.height = 100;
    const auto bytes = [&](cl_uint shape) {
        bound.shape = build.shape = shape;
        return std::pair(sizes_of(rsh_bound_query, context, bound).output_bytes,
                         sizes_of(rsh_build_query, context, build).output_bytes);
    };
    EXPECT_EQ(bytes(RSH_SHAPE_DEFAULT), bytes(rsh_engine_shape(default_engine())));
    EXPECT_NE(bytes(RSH_SHAPE_CONE), bytes(RSH_SHAPE_BOX));
}

// Memory of the reductions tells how the kernels were compiled.
TEST(Defaults, AreKernelsOfOneLaneUnlessADeviceHasVectorRegisters) {
    rsh_reduce_desc desc = {};
    desc.element_bytes = 4;
    desc.count = 1u << 31;
    const auto bytes = [&](cl_uint vector_width) {
        const test::OwnContext context(vector_width);
        return sizes_of(rsh_reduce_query, context.get(), desc).scratch_bytes;
    };
    const cl_uint native = test::device().device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>();
    EXPECT_EQ(bytes(0), bytes(is_cpu() && native >= 4 ? 4 : 1));
    EXPECT_NE(bytes(1), bytes(4));
}

class DefaultsOfACase : public ::testing::TestWithParam<test::NamedCase> {};

TEST_P(DefaultsOfACase, FindTheHitsOfBruteForce) {
    test::Random random(9);
    const test::Case c = GetParam().make(random);
    const test::DeviceMesh mesh(c.mesh);
    const auto expected = closest_hits(mesh, c.rays, test::brute_force());
    for (const bool is_own : {false, true}) {
        test::TraceOptions defaults;
        defaults.own_bounds = defaults.own_scratch = is_own;
        EXPECT_TRUE(test::same_bits(closest_hits(mesh, c.rays, defaults), expected, "hits"))
            << (is_own ? "with bounds of the caller's" : "with bounds made in scratch");
    }
}

INSTANTIATE_TEST_SUITE_P(All, DefaultsOfACase, ::testing::ValuesIn(test::all_cases()),
                         test::case_name);

TEST(Defaults, RenderTheFrameOfEveryEngine) {
    const test::DeviceScene scene(test::gallery());
    test::FrameOptions options;
    options.width = options.height = 24;
    options.bounces = 2;
    const auto expected = frame(scene, options);
    options.own_scratch = true;
    EXPECT_TRUE(test::same_bits(frame(scene, options), expected, "pixels"));
    test::KeptFrames kept(RSH_ENGINE_DEFAULT, scene.desc.geometry);
    for (const char* what : {"kept", "refitted"})
        EXPECT_TRUE(test::same_bits(kept.render(scene, options), expected, "pixels")) << what;
    for (options.engine = 1; rsh_engine_name(options.engine); ++options.engine)
        EXPECT_TRUE(test::same_bits(frame(scene, options), expected, "pixels"))
            << rsh_engine_name(options.engine);
}

}  // namespace
