// counts_test.cpp - what rsh asks OpenCL for, as the layer of counts.cpp counts it from outside.
// Fails without the layer.
#include <gtest/gtest.h>

#include "api/valid_calls.hpp"
#include "support/layers/counted.hpp"

namespace {

using test::device;
using test::expect_nothing_made;
using test::Since;

void expect_nothing_kept(const rsh_counts& counts) {
    EXPECT_EQ(counts.bytes_alive, 0u);
    EXPECT_EQ(counts.buffers_alive, 0u);
    EXPECT_EQ(counts.sub_buffers_alive, 0u);
    EXPECT_EQ(counts.programs_alive, 0u);
    EXPECT_EQ(counts.kernels_alive, 0u);
    EXPECT_EQ(counts.contexts_alive, 0u);
    EXPECT_EQ(counts.queues_alive, 0u);
    EXPECT_EQ(counts.events_alive, 0u);
}

int count_wave(cl_uint, cl_uint, void* waves) {
    ++*static_cast<cl_uint*>(waves);
    return 0;
}

// The gallery, which has mirror, glass and shadow, on a context of its own.
struct Gallery {
    const test::Scene host = test::gallery();
    const test::DeviceScene scene{host};
    const test::Buffer<cl_float4> colour{32 * 24};
    const test::OwnContext context;
    cl_uint waves = 0;
    rsh_frame_desc desc = {};

    Gallery(cl_uint engine, cl_uint bounces) {
        desc.struct_size = sizeof desc;
        desc.scene = &scene.desc;
        desc.camera = test::gallery_camera(32, 24);
        desc.width = 32;
        desc.height = 24;
        desc.bounces = bounces;
        desc.engine = engine;
        desc.colour = colour.get();
        desc.progress = count_wave;
        desc.progress_user = &waves;
    }

    size_t scratch_bytes() const {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_frame_query(context.get(), &desc, &sizes));
        return sizes.scratch_bytes;
    }

    rsh_counts render() {
        waves = 0;
        const Since begin;
        RSH_CHECK(rsh_frame(context.get(), device().queue(), &desc, 0, nullptr, nullptr));
        const rsh_counts counts = begin.now();
        device().queue.finish();
        return counts;
    }
};

class Counts : public ::testing::TestWithParam<cl_uint> {};

TEST_P(Counts, MakeNothingAfterTheFirstFrame) {
    Gallery gallery(GetParam(), 2);
    const rsh_counts first = gallery.render();
    EXPECT_GT(first.buffers, 0u);
    EXPECT_GT(first.launches, 0u);
    for (int frame = 0; frame < 2; ++frame) expect_nothing_made(gallery.render());
}

TEST_P(Counts, CompileNothingInTheFirstFrameWhenItWasPrepared) {
    Gallery gallery(GetParam(), 2);
    rsh_prepare_desc prepare = {};
    prepare.struct_size = sizeof prepare;
    prepare.frame = &gallery.desc;
    const Since begin;
    RSH_CHECK(rsh_prepare(gallery.context.get(), &prepare));
    const rsh_counts prepared = begin.now();
    EXPECT_GT(prepared.compiles + prepared.binary_builds, 0u);
    EXPECT_EQ(prepared.launches + prepared.fills + prepared.copies + prepared.waits, 0u);
    EXPECT_EQ(prepared.buffers + prepared.sub_buffers, 0u);
    EXPECT_EQ(gallery.waves, 0u);
    const rsh_counts first = gallery.render();
    EXPECT_EQ(first.compiles, 0u);
    EXPECT_EQ(first.binary_builds, 0u);
    EXPECT_GT(first.launches, 0u);
}

TEST_P(Counts, MakeNothingWhileBoundsAreRefitted) {
    Gallery gallery(GetParam(), 1);
    rsh_bound_desc bound = {};
    bound.struct_size = sizeof bound;
    bound.geometry = gallery.scene.desc.geometry;
    bound.shape = rsh_engine_shape(GetParam());
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    RSH_CHECK(rsh_bound_query(gallery.context.get(), &bound, &sizes));
    const test::Buffer<uint8_t> bounds(sizes.output_bytes);
    gallery.desc.bounds = bounds.get();
    gallery.desc.mode = RSH_BOUND_QUALITY;
    gallery.render();
    gallery.desc.mode = RSH_BOUND_REFIT;
    for (const float height : {0.0f, 0.1f, 0.2f}) {
        test::Scene moved = gallery.host;
        for (auto& position : moved.mesh.vertices) position.y += height;
        const test::DeviceScene scene(moved);
        gallery.desc.scene = &scene.desc;
        expect_nothing_made(gallery.render());
    }
}

TEST_P(Counts, KeepTheBytesOfTheQueryAlone) {
    Gallery gallery(GetParam(), 2);
    const size_t bytes = gallery.scratch_bytes();
    const Since begin;
    const cl::Buffer scratch(device().context, CL_MEM_READ_WRITE, bytes);
    gallery.desc.scratch = scratch();
    gallery.render();
    EXPECT_EQ(begin.now().bytes_alive, bytes);
    EXPECT_EQ(begin.now().buffers, 1u);
}

TEST_P(Counts, ReleaseAllThatAFrameMade) {
    device();
    const Since begin;
    { Gallery(GetParam(), 2).render(); }
    EXPECT_GT(begin.now().kernels, 0u);
    expect_nothing_kept(begin.now());
}

TEST_P(Counts, WaitOncePerStripAndLaunchAsMuchPerBounce) {
    size_t launches[5] = {};
    for (cl_uint bounces = 0; bounces < 5; ++bounces) {
        Gallery gallery(GetParam(), bounces);
        gallery.render();
        const rsh_counts counts = gallery.render();
        EXPECT_EQ(counts.waits, bounces > 0 ? 1u : 0u) << bounces << " bounces";
        EXPECT_EQ(gallery.waves, bounces);
        launches[bounces] = counts.launches;
        const size_t per_bounce = launches[bounces > 0] - launches[0];
        EXPECT_LE(counts.launches, launches[0] + per_bounce * bounces) << bounces << " bounces";
    }
}

INSTANTIATE_TEST_SUITE_P(All, Counts, ::testing::Range(cl_uint{1}, cl_uint{5}));

TEST(Counts, NoWaitInCallsThatOnlyEnqueue) {
    const test::ValidCalls valid;
    const rsh_reduce_desc reduce = valid.reduce();
    const rsh_build_desc build = valid.build();
    const rsh_traverse_desc traverse = valid.traverse();
    for (int round = 0; round < 2; ++round) {  // the first one compiles
        const Since begin;
        const rsh_context context = device().rsh;
        RSH_CHECK(rsh_reduce(context, device().queue(), &reduce, 0, nullptr, nullptr));
        RSH_CHECK(rsh_build(context, device().queue(), &build, 0, nullptr, nullptr));
        RSH_CHECK(rsh_traverse(context, device().queue(), &traverse, 0, nullptr, nullptr));
        EXPECT_EQ(begin.now().waits, 0u);
        EXPECT_GT(begin.now().launches, 2u);
        device().queue.finish();
        EXPECT_EQ(begin.now().waits, 1u) << "the layer does not count clFinish";
    }
}

TEST(Counts, TellBuildsOfBinariesFromThoseOfSources) {
    const test::Device& device = test::device();
    const Since begin;
    cl::Program source(device.context, "kernel void one(global int* p) { *p = 1; }");
    source.build();
    EXPECT_EQ(begin.now().compiles, 1u);
    EXPECT_EQ(begin.now().binary_builds, 0u);
    cl::Program binary(device.context, {device.device}, source.getInfo<CL_PROGRAM_BINARIES>());
    binary.build();
    EXPECT_EQ(begin.now().compiles, 1u);
    EXPECT_EQ(begin.now().binary_builds, 1u);
}

TEST(Counts, LetThePeakBeginAnew) {
    const cl::Context& context = device().context;
    const auto restart_peak = test::of_layer<rsh_restart_peak_function>("rsh_restart_peak");
    { const cl::Buffer high(context, CL_MEM_READ_WRITE, 8192); }
    const cl::Buffer stays(context, CL_MEM_READ_WRITE, 512);
    restart_peak();
    const size_t alive = test::counts_now().bytes_alive;
    EXPECT_EQ(test::counts_now().bytes_peak, alive);
    { const cl::Buffer low(context, CL_MEM_READ_WRITE, 1024); }
    EXPECT_EQ(test::counts_now().bytes_alive, alive);
    EXPECT_EQ(test::counts_now().bytes_peak, alive + 1024);
}

TEST(Counts, HoldABufferWhileASubBufferOfItIsAlive) {
    const Since begin;
    cl::Buffer whole(device().context, CL_MEM_READ_WRITE, 4096);
    cl_buffer_region region = {0, 1024};
    cl::Buffer part =
        whole.createSubBuffer(CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region);
    EXPECT_EQ(begin.now().sub_buffers, 1u);
    whole = cl::Buffer();
    EXPECT_EQ(begin.now().bytes_alive, 4096u);
    part = cl::Buffer();
    expect_nothing_kept(begin.now());
}

}  // namespace
