// two_loaders_test.cpp - rsh with objects of a loader that is not the one it is linked to. No test
// here may list platforms by the linked loader (rsh_find_device does): that hides the crash.
#include <gtest/gtest.h>

#include <rsh/rsh.hpp>

#include <cstdio>

#include "device/objects/opencl.hpp"
#include "loaders/second_loader.hpp"

namespace {

using loaders::second;

class TwoLoaders : public ::testing::Test {
protected:
    loaders::SecondDevice own_;
    rsh::Context rsh_{own_.context(), own_.device()};
};

// For debian_sid.sh, which must know that it met the case.
TEST_F(TwoLoaders, WhoseFunctionsAreCalled) {
    std::printf("rsh calls %s\n",
                ::rsh::driver_functions(own_.context()) ? "the driver" : "its loader");
}

// Two facing walls of triangles, the far one a mirror, and a lamp between.
rsh_scene walls(loaders::SecondDevice& device) {
    std::vector<cl_float> vertices;
    std::vector<cl_uint> materials;
    const auto triangle = [&](float x, float y, float z, float size) {
        for (const float corner : {x, y, z, x + size, y, z, x, y + size, z})
            vertices.push_back(corner);
        materials.push_back(z < 0);
    };
    for (int i = 0; i < 400; ++i)
        for (const float z : {-4.0f, 4.0f})
            triangle(static_cast<float>(i % 20) - 10, static_cast<float>(i / 20) - 10, z, 0.9f);
    rsh_material flat = {}, mirror = {};
    flat.diffuse = {{0.5f, 0.5f, 0.5f, 0}};
    mirror.reflection = {{0.9f, 0.9f, 0.9f, 0}};
    flat.texture = mirror.texture = RSH_NO_TEXTURE;
    rsh_light lamp = {};
    lamp.colour = {{1, 1, 1, 0}};
    lamp.casts_shadow = 1;

    auto scene = rsh::make<rsh_scene>();
    scene.geometry.vertices = device.upload(vertices);
    scene.geometry.vertex_count = static_cast<cl_uint>(vertices.size() / 3);
    scene.geometry.triangle_count = scene.geometry.vertex_count / 3;
    scene.material_ids = device.upload(materials);
    const std::vector<rsh_material> both = {flat, mirror};
    scene.materials = device.upload(both);
    scene.material_count = 2;
    scene.lights = device.upload(std::vector<rsh_light>{lamp});
    scene.light_count = 1;
    rsh::check(rsh_find_features(&scene, both.data(), &lamp));
    return scene;
}

rsh_frame_desc frame_of(loaders::SecondDevice& device, const rsh_scene& scene) {
    auto frame = rsh::make<rsh_frame_desc>();
    frame.scene = &scene;
    frame.camera.forward = {{0, 0, -1, 0}};
    frame.camera.right = {{1, 0, 0, 0}};
    frame.camera.up = {{0, 1, 0, 0}};
    frame.width = frame.height = 128;
    frame.bounces = 2;
    frame.colour = device.buffer(sizeof(cl_float4) * frame.width * frame.height);
    frame.audit_rays = 1000;
    frame.audit = device.buffer(sizeof(rsh_audit_report));
    return frame;
}

TEST_F(TwoLoaders, AFrameHasTheHitsOfBruteForce) {
    const rsh_scene scene = walls(own_);
    for (const cl_uint engine : {RSH_ENGINE_TILES, RSH_ENGINE_PAPER_FAITHFUL}) {
        rsh_frame_desc frame = frame_of(own_, scene);
        frame.engine = engine;
        rsh::check(rsh_frame(rsh_.get(), own_.queue(), &frame, 0, nullptr, nullptr));
        const auto report = own_.download<rsh_audit_report>(frame.audit, 1)[0];
        EXPECT_GT(report.rays, 2000u) << rsh_engine_name(engine);
        EXPECT_EQ(report.differences, 0u) << rsh_engine_name(engine);
        size_t seen = 0;
        for (const cl_float4& pixel : own_.download<cl_float4>(frame.colour, 128 * 128))
            seen += pixel.s[0] > 0 && pixel.s[3] == 1;
        EXPECT_GT(seen, 1000u) << rsh_engine_name(engine);
    }
}

TEST_F(TwoLoaders, StatisticsAreRead) {
    const rsh_scene scene = walls(own_);
    const rsh_frame_desc frame = frame_of(own_, scene);
    rsh::check(rsh_count_statistics(rsh_.get(), CL_TRUE));
    rsh::check(rsh_frame(rsh_.get(), own_.queue(), &frame, 0, nullptr, nullptr));
    auto statistics = rsh::make<rsh_statistics>();
    rsh::check(rsh_get_statistics(rsh_.get(), &statistics));
    EXPECT_GT(statistics.launches, 0u);
    EXPECT_GT(statistics.stage_ns[RSH_STAGE_INTERSECT], 0u);
    EXPECT_GT(statistics.active_rays[1], 0u);
    EXPECT_EQ(rsh_device_status(rsh_.get(), own_.queue()), RSH_SUCCESS);
}

// Released while its commands are under way: they are the last to hold its memory.
TEST_F(TwoLoaders, EventsGoBothWays) {
    std::vector<cl_uint> numbers(10000);
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = i % 3 ? static_cast<cl_uint>(i) : RSH_NO_HIT;
    auto reduce = rsh::make<rsh_reduce_desc>();
    reduce.keep = RSH_KEEP_NOT_NULL;
    reduce.element_bytes = sizeof(cl_uint);
    reduce.count = static_cast<cl_uint>(numbers.size());
    reduce.input = own_.upload(numbers);
    reduce.output = own_.buffer(sizeof(cl_uint) * numbers.size());
    reduce.output_count = own_.buffer(sizeof(cl_uint));

    cl_int status = CL_SUCCESS;
    cl_event go = second().clCreateUserEvent(own_.context(), &status), done = nullptr;
    loaders::require(status, "clCreateUserEvent");
    rsh::check(rsh_reduce(rsh_.get(), own_.queue(), &reduce, 1, &go, &done));
    rsh_ = rsh::Context(static_cast<rsh_context>(nullptr));
    loaders::require(second().clSetUserEventStatus(go, CL_COMPLETE), "clSetUserEventStatus");
    loaders::require(second().clWaitForEvents(1, &done), "clWaitForEvents");
    second().clReleaseEvent(done);
    second().clReleaseEvent(go);

    EXPECT_EQ(own_.download<cl_uint>(reduce.output_count, 1)[0], 6666u);
    EXPECT_EQ(own_.download<cl_uint>(reduce.output, 6666)[6665], 9998u);
}

TEST_F(TwoLoaders, TheSelfTestFindsNothing) {
    auto report = rsh::make<rsh_selftest>();
    rsh::check(rsh_device_selftest(rsh_.get(), own_.queue(), &report));
    EXPECT_GT(report.cases, 0u);
    EXPECT_EQ(report.unsafe_strategies, 0u) << report.first_failure;
    EXPECT_EQ(report.wrong_arithmetic, 0u) << report.arithmetic_failure;
}

}  // namespace
