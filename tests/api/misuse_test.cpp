// misuse_test.cpp - a wrong argument gives the status that rsh.h names, a message with the
// field, the actual and the required value, and enqueues nothing.
#include <gtest/gtest.h>

#include <functional>

#include "api/calls.hpp"
#include "api/struct_size.hpp"
#include "api/valid_calls.hpp"
#include "support/ways.hpp"

namespace {

using test::call;
using test::ValidCalls;

constexpr size_t kAny = ~size_t{0};

class Misuse : public ::testing::Test {
protected:
    // `break_it` spoils the descriptor; every word must appear in the message.
    template <class Desc>
    void refuses(Desc desc, const std::function<void(Desc&)>& break_it, rsh_status status,
                 const std::vector<std::string>& words) {
        break_it(desc);
        cl_event event = nullptr;
        EXPECT_EQ(call(&desc, &event), status) << words[0] << ": " << rsh_last_error();
        EXPECT_EQ(event, nullptr) << words[0];
        test::expect_said(words);
        EXPECT_TRUE(valid_.outputs_untouched()) << words[0];
    }

    template <class Desc>
    void refuses_struct_sizes(Desc desc) {
        EXPECT_EQ(call(static_cast<const Desc*>(nullptr), nullptr), RSH_INVALID_VALUE);
        EXPECT_NE(std::string(rsh_last_error()).find("NULL"), std::string::npos);
        const size_t first = rsh::FirstVersion<Desc>::bytes;
        for (const size_t size : {size_t{0}, first - 1, sizeof desc + 8, kAny})
            refuses<Desc>(desc, [=](Desc& d) { d.struct_size = size; }, RSH_INVALID_VALUE,
                          {"struct_size", std::to_string(size), std::to_string(sizeof desc)});
    }

    test::Buffer<uint32_t> short_{1};
    ValidCalls valid_;
};

TEST_F(Misuse, OfStructSizesIsRefusedByEveryCall) {
    refuses_struct_sizes(valid_.rasterize());
    refuses_struct_sizes(valid_.bound());
    refuses_struct_sizes(valid_.build());
    refuses_struct_sizes(valid_.traverse());
    refuses_struct_sizes(valid_.trace());
    refuses_struct_sizes(valid_.audit());
    refuses_struct_sizes(valid_.spawn());
    refuses_struct_sizes(valid_.spawn_wave());
    refuses_struct_sizes(valid_.gather_wave());
    refuses_struct_sizes(valid_.shadow());
    refuses_struct_sizes(valid_.find_surfaces());
    refuses_struct_sizes(valid_.shade());
    refuses_struct_sizes(valid_.frame());
    refuses_struct_sizes(valid_.reduce());
}

TEST_F(Misuse, OfContextAndQueueIsRefused) {
    const auto desc = valid_.reduce();
    EXPECT_EQ(rsh_reduce(nullptr, test::device().queue(), &desc, 0, nullptr, nullptr),
              RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("context"), std::string::npos);
    EXPECT_EQ(rsh_reduce(test::device().rsh, nullptr, &desc, 0, nullptr, nullptr),
              RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("queue"), std::string::npos);

    const cl::Context other(test::device().device);
    const cl::CommandQueue foreign(other, test::device().device);
    EXPECT_EQ(rsh_reduce(test::device().rsh, foreign(), &desc, 0, nullptr, nullptr),
              RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("queue"), std::string::npos);
    EXPECT_TRUE(valid_.outputs_untouched());
}

TEST_F(Misuse, OfWaitListsIsRefused) {
    const auto desc = valid_.reduce();
    cl_event none = nullptr;
    EXPECT_EQ(
        rsh_reduce(test::device().rsh, test::device().queue(), &desc, 1, nullptr, nullptr),
        RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_reduce(test::device().rsh, test::device().queue(), &desc, 0, &none, nullptr),
              RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_reduce(test::device().rsh, test::device().queue(), &desc, 1, &none, nullptr),
              RSH_INVALID_VALUE);
    EXPECT_TRUE(valid_.outputs_untouched());
}

TEST_F(Misuse, OfBuffersOfAnotherContextIsRefused) {
    const cl::Context other(test::device().device);
    const cl::Buffer foreign(other, CL_MEM_READ_WRITE, 65536);
    refuses<rsh_reduce_desc>(valid_.reduce(), [&](auto& d) { d.input = foreign(); },
                             RSH_INVALID_VALUE, {"input", "context"});
    refuses<rsh_build_desc>(valid_.build(), [&](auto& d) { d.rays = foreign(); },
                            RSH_INVALID_VALUE, {"rays", "context"});
    refuses<rsh_traverse_desc>(valid_.traverse(), [&](auto& d) { d.hits = foreign(); },
                               RSH_INVALID_VALUE, {"hits", "context"});
    refuses<rsh_frame_desc>(valid_.frame(), [&](auto& d) { d.colour = foreign(); },
                            RSH_INVALID_VALUE, {"colour", "context"});
}

TEST_F(Misuse, OfBoundsThatAFrameUpdates) {
    const auto desc = valid_.frame();
    refuses<rsh_frame_desc>(desc, [](auto& d) { d.mode = 1; }, RSH_INVALID_VALUE,
                            {"mode", "1", "0 without bounds"});
    refuses<rsh_frame_desc>(desc, [&](auto& d) { d.bounds = short_.get(); },
                            RSH_BUFFER_TOO_SMALL, {"bounds", "4 bytes"});
}

TEST_F(Misuse, OfScratchForListsOfRays) {
    auto list = valid_.build();
    list.shape = RSH_SHAPE_BOX;
    list.width *= list.height;
    list.height = 1;
    const test::Buffer<uint8_t> nodes(1u << 20);
    list.nodes = nodes.get();
    refuses<rsh_build_desc>(list, [&](auto& d) { d.scratch = short_.get(); },
                            RSH_BUFFER_TOO_SMALL, {"scratch", "4 bytes"});
}

TEST_F(Misuse, OfListsCountedOnTheDevice) {
    const test::Buffer<uint32_t> count(1);
    const cl::Buffer half(test::device().context, CL_MEM_READ_WRITE, 2);
    const cl::Context other(test::device().device);
    const cl::Buffer foreign(other, CL_MEM_READ_WRITE, 4);
    const auto refuses_wrong_counts = [&](auto list) {
        using Desc = decltype(list);
        list.shape = RSH_SHAPE_BOX;
        list.list_count = count.get();
        refuses<Desc>(list, [](Desc& d) { d.height = 2; }, RSH_INVALID_VALUE,
                      {"height", "2", "0 or 1", "list_count"});
        list.width *= list.height;
        list.height = 1;
        refuses<Desc>(list, [&](Desc& d) { d.list_count = half(); }, RSH_BUFFER_TOO_SMALL,
                      {"list_count", "2 bytes", "4"});
        refuses<Desc>(list, [&](Desc& d) { d.list_count = foreign(); }, RSH_INVALID_VALUE,
                      {"list_count", "context"});
        return list;
    };
    using Build = rsh_build_desc;
    const test::Buffer<uint8_t> nodes(1u << 20);
    refuses<Build>(refuses_wrong_counts(valid_.build()),
                   [&](Build& d) { d.list_count = d.nodes = nodes.get(); }, RSH_INVALID_VALUE,
                   {"nodes", "overlap", "list_count"});
    using Traverse = rsh_traverse_desc;
    refuses<Traverse>(refuses_wrong_counts(valid_.traverse()),
                      [](Traverse& d) { d.list_count = d.hits; }, RSH_INVALID_VALUE,
                      {"hits", "overlap", "list_count"});
}

TEST_F(Misuse, OfTestsPerRayIsRefused) {
    using Traverse = rsh_traverse_desc;
    auto desc = valid_.traverse();
    desc.engine = RSH_ENGINE_BRUTE_FORCE;
    refuses<Traverse>(desc, [&](Traverse& d) { d.tests_per_ray = short_.get(); },
                      RSH_BUFFER_TOO_SMALL, {"tests_per_ray", "4", "256"});
    refuses<Traverse>(desc, [](Traverse& d) { d.tests_per_ray = d.hits; }, RSH_INVALID_VALUE,
                      {"tests_per_ray", "overlap", "hits"});
    refuses<Traverse>(
        desc, [](Traverse& d) { d.engine = RSH_ENGINE_PAPER, d.tests_per_ray = d.hits; },
        RSH_INVALID_VALUE, {"tests_per_ray", "paper", "tiles or brute_force"});
}

TEST_F(Misuse, OfReduceIsRefused) {
    using Desc = rsh_reduce_desc;
    const auto desc = valid_.reduce();
    for (const cl_uint bytes : {0u, 1u, 5u, 20u, 0xfffffffcu})
        refuses<Desc>(desc, [=](Desc& d) { d.element_bytes = bytes; }, RSH_INVALID_VALUE,
                      {"element_bytes", std::to_string(bytes), "16"});
    refuses<Desc>(desc, [](Desc& d) { d.keep = 3; }, RSH_INVALID_VALUE, {"keep", "3"});
    refuses<Desc>(desc, [](Desc& d) { d.strategy = 99; }, RSH_INVALID_VALUE,
                  {"strategy", "99"});
    refuses<Desc>(desc, [](Desc& d) { d.count = 1025; }, RSH_BUFFER_TOO_SMALL,
                  {"4096", "4100"});
    refuses<Desc>(desc, [](Desc& d) { d.count = 1u << 31; }, RSH_BUFFER_TOO_SMALL,
                  {"4096", "8589934592"});
    for (const cl_uint count : {(1u << 31) + 1, 0xffffffffu})
        refuses<Desc>(desc, [=](Desc& d) { d.count = count; }, RSH_INVALID_VALUE,
                      {"count", std::to_string(count), "2147483648"});
    refuses<Desc>(desc, [](Desc& d) { d.input = nullptr; }, RSH_INVALID_VALUE,
                  {"input", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.flags = nullptr; }, RSH_INVALID_VALUE,
                  {"flags", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.output = nullptr; }, RSH_INVALID_VALUE,
                  {"output", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.output_count = nullptr; }, RSH_INVALID_VALUE,
                  {"output_count", "NULL"});
    auto scanned = desc;
    scanned.strategy = RSH_STRATEGY_SCAN_SCATTER;
    refuses<Desc>(scanned, [&](Desc& d) { d.scratch = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"scratch", "4 bytes"});
    auto by_bits = desc;
    by_bits.keep = RSH_KEEP_BITS;
    refuses<Desc>(by_bits, [&](Desc& d) { d.flags = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"flags", "4 bytes", "128"});
    refuses<Desc>(by_bits, [](Desc& d) { d.flags = nullptr; }, RSH_INVALID_VALUE,
                  {"flags", "NULL"});
}

TEST_F(Misuse, OfGeometryIsRefused) {
    using Desc = rsh_bound_desc;
    const auto desc = valid_.bound();
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertices = nullptr; }, RSH_INVALID_VALUE,
                  {"geometry.vertices", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertex_stride = 8; }, RSH_INVALID_VALUE,
                  {"vertex_stride", "8", "12"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertex_stride = 14; }, RSH_INVALID_VALUE,
                  {"vertex_stride", "14"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertices_offset = 2; }, RSH_INVALID_VALUE,
                  {"vertices_offset", "2"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.indices_offset = 3; }, RSH_INVALID_VALUE,
                  {"indices_offset", "3"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertices_offset = 4; }, RSH_BUFFER_TOO_SMALL,
                  {"geometry.vertices"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertices_offset = ~cl_ulong{3}; },
                  RSH_BUFFER_TOO_SMALL, {"geometry.vertices"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.indices_offset = 4; }, RSH_BUFFER_TOO_SMALL,
                  {"geometry.indices"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.indices_offset = ~cl_ulong{3}; },
                  RSH_BUFFER_TOO_SMALL, {"geometry.indices"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertex_count = 0xffffffffu; },
                  RSH_BUFFER_TOO_SMALL, {"geometry.vertices"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.triangle_count = 1u << 28; },
                  RSH_INVALID_VALUE, {"triangle_count", "268435456"});
    refuses<Desc>(desc, [](Desc& d) { d.bounds = nullptr; }, RSH_INVALID_VALUE,
                  {"bounds", "NULL"});
    refuses<Desc>(desc, [&](Desc& d) { d.bounds = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"bounds", "4"});
    refuses<Desc>(desc, [](Desc& d) { d.shape = 77; }, RSH_INVALID_VALUE, {"shape", "77"});
}

TEST_F(Misuse, OfBuildIsRefused) {
    using Desc = rsh_build_desc;
    const auto desc = valid_.build();
    refuses<Desc>(desc, [](Desc& d) { d.width = 16385; }, RSH_INVALID_VALUE,
                  {"width", "16385", "16384"});
    refuses<Desc>(desc, [](Desc& d) { d.height = 16385; }, RSH_INVALID_VALUE,
                  {"height", "16385", "16384"});
    refuses<Desc>(desc, [](Desc& d) { d.width = (1u << 28) + 1, d.height = 1; },
                  RSH_INVALID_VALUE, {"width", "268435457"});
    refuses<Desc>(desc, [](Desc& d) { d.width = 9; }, RSH_BUFFER_TOO_SMALL,
                  {"rays", "2048", "2304"});
    refuses<Desc>(desc, [](Desc& d) { d.rays = nullptr; }, RSH_INVALID_VALUE, {"rays", "NULL"});
    refuses<Desc>(desc, [&](Desc& d) { d.nodes = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"nodes", "4"});
    refuses<Desc>(desc, [](Desc& d) { d.shape = 77; }, RSH_INVALID_VALUE, {"shape", "77"});
}

TEST_F(Misuse, OfTraverseIsRefused) {
    using Desc = rsh_traverse_desc;
    const auto desc = valid_.traverse();
    refuses<Desc>(desc, [](Desc& d) { d.engine = 77; }, RSH_INVALID_VALUE, {"engine", "77"});
    refuses<Desc>(desc, [](Desc& d) { d.strategy = 77; }, RSH_INVALID_VALUE,
                  {"strategy", "77"});
    refuses<Desc>(desc, [](Desc& d) { d.query = 4; }, RSH_INVALID_VALUE, {"query", "4"});
    refuses<Desc>(desc, [](Desc& d) { d.hits = nullptr; }, RSH_INVALID_VALUE, {"hits", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.query = RSH_QUERY_COUNT; }, RSH_INVALID_VALUE,
                  {"hit_counts", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.query = RSH_QUERY_ALL; }, RSH_INVALID_VALUE,
                  {"hit_offsets", "NULL"});
    const test::Buffer<cl_ulong> offsets(test::kRays + 1);
    const auto all = [&](Desc& d) {
        d.query = RSH_QUERY_ALL, d.hit_offsets = offsets.get(), d.hit_capacity = 1;
    };
    refuses<Desc>(desc, [&](Desc& d) { all(d), d.hits = nullptr; }, RSH_INVALID_VALUE,
                  {"hits", "NULL"});
    refuses<Desc>(desc, [&](Desc& d) { all(d), d.hit_capacity = (1ull << 31) + 1; },
                  RSH_INVALID_VALUE, {"hit_capacity", "2147483649", "2147483648"});
    refuses<Desc>(desc, [&](Desc& d) { all(d), d.hit_capacity = 1 << 20; },
                  RSH_BUFFER_TOO_SMALL, {"hits", "16777216"});
    refuses<Desc>(desc, [&](Desc& d) { all(d), d.hits = offsets.get(); }, RSH_INVALID_VALUE,
                  {"hits", "hit_offsets"});
    refuses<Desc>(desc, [](Desc& d) { d.budget = RSH_MIN_BUDGET - 1; }, RSH_INVALID_VALUE,
                  {"budget", "65535", "65536"});
    refuses<Desc>(desc, [](Desc& d) { d.query = RSH_QUERY_ANY; }, RSH_INVALID_VALUE,
                  {"occlusion", "NULL"});
    refuses<Desc>(desc,
                  [&](Desc& d) {
                      d.query = RSH_QUERY_ANY, d.occlusion = valid_.occlusion.get(),
                      d.occlusion_bit = 32;
                  },
                  RSH_INVALID_VALUE, {"occlusion_bit", "32"});
    refuses<Desc>(
        desc, [](Desc& d) { d.engine = RSH_ENGINE_PAPER_FAITHFUL, d.shape = RSH_SHAPE_BOX; },
        RSH_INVALID_VALUE, {"shape", "box", "cone", "paper_faithful"});
    refuses<Desc>(desc, [](Desc& d) { d.engine = RSH_ENGINE_TILES, d.shape = RSH_SHAPE_CONE; },
                  RSH_INVALID_VALUE, {"shape", "cone", "box", "tiles"});
    refuses<Desc>(desc, [](Desc& d) { d.shape = 77, d.engine = RSH_ENGINE_DEFAULT; },
                  RSH_INVALID_VALUE, {"shape", "77"});
    for (const test::TraceOptions& way : test::all_ways()) {
        Desc with_engine = desc;
        with_engine.engine = way.engine;
        with_engine.shape = way.bound;
        refuses<Desc>(with_engine, [](Desc&) {}, RSH_INVALID_VALUE, {"nodes", "NULL"});
        refuses<Desc>(with_engine, [&](Desc& d) { d.bounds = short_.get(); },
                      RSH_BUFFER_TOO_SMALL, {"bounds", "4"});
    }
}

TEST_F(Misuse, OfRasterizeIsRefused) {
    using Desc = rsh_rasterize_desc;
    const auto desc = valid_.rasterize();
    for (const cl_uint side : {0u, 16385u, 0xffffffffu}) {
        refuses<Desc>(desc, [=](Desc& d) { d.width = side; }, RSH_INVALID_VALUE,
                      {"width", std::to_string(side), "16384"});
        refuses<Desc>(desc, [=](Desc& d) { d.height = side; }, RSH_INVALID_VALUE,
                      {"height", std::to_string(side), "16384"});
    }
    refuses<Desc>(desc, [](Desc& d) { d.camera.eye.s[1] = NAN; }, RSH_INVALID_VALUE,
                  {"camera.eye", "nan"});
    refuses<Desc>(desc, [](Desc& d) { d.camera.up.s[2] = INFINITY; }, RSH_INVALID_VALUE,
                  {"camera.up", "inf"});
    refuses<Desc>(desc,
                  [](Desc& d) {
                      d.camera.forward = {{0, 0, 0, 0}};
                  },
                  RSH_INVALID_VALUE, {"camera.forward"});
    refuses<Desc>(desc, [](Desc& d) { d.camera.eye.s[3] = NAN; }, RSH_INVALID_VALUE,
                  {"near", "nan"});
    refuses<Desc>(desc, [](Desc& d) { d.camera.forward.s[3] = NAN; }, RSH_INVALID_VALUE,
                  {"far", "nan"});
    refuses<Desc>(desc, [&](Desc& d) { d.rays = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"rays", "4", "2048"});
    refuses<Desc>(desc, [&](Desc& d) { d.hits = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"hits", "4", "1024"});
}

TEST_F(Misuse, OfAuditsIsRefused) {
    using Desc = rsh_audit_desc;
    const auto desc = valid_.audit();
    refuses<Desc>(desc, [](Desc& d) { d.ray_count = (1u << 28) + 1; }, RSH_INVALID_VALUE,
                  {"ray_count", "268435457", "268435456"});
    refuses<Desc>(desc, [](Desc& d) { d.ray_count = 65; }, RSH_BUFFER_TOO_SMALL,
                  {"rays", "2048", "2080"});
    refuses<Desc>(desc, [](Desc& d) { d.rays = nullptr; }, RSH_INVALID_VALUE, {"rays", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.hits = nullptr; }, RSH_INVALID_VALUE, {"hits", "NULL"});
    refuses<Desc>(desc, [&](Desc& d) { d.hits = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"hits", "4", "1024"});
    refuses<Desc>(desc, [](Desc& d) { d.query = 4; }, RSH_INVALID_VALUE, {"query", "4"});
    refuses<Desc>(desc, [](Desc& d) { d.query = RSH_QUERY_COUNT; }, RSH_INVALID_VALUE,
                  {"hit_counts", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.query = RSH_QUERY_ALL; }, RSH_INVALID_VALUE,
                  {"hit_offsets", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.query = RSH_QUERY_ANY; }, RSH_INVALID_VALUE,
                  {"occlusion", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.query = RSH_QUERY_ANY, d.occlusion_bit = 32; },
                  RSH_INVALID_VALUE, {"occlusion_bit", "32"});
    refuses<Desc>(desc, [](Desc& d) { d.report = nullptr; }, RSH_INVALID_VALUE,
                  {"report", "NULL"});
    refuses<Desc>(desc, [&](Desc& d) { d.report = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"report", "4", "32"});
    refuses<Desc>(desc, [](Desc& d) { d.report = d.hits; }, RSH_INVALID_VALUE,
                  {"report", "overlap", "hits"});
    refuses<Desc>(desc, [](Desc& d) { d.list_count = d.report; }, RSH_INVALID_VALUE,
                  {"report", "overlap", "list_count"});
    const cl::Buffer half(test::device().context, CL_MEM_READ_WRITE, 2);
    refuses<Desc>(desc, [&](Desc& d) { d.list_count = half(); }, RSH_BUFFER_TOO_SMALL,
                  {"list_count", "2 bytes", "4"});
    refuses<Desc>(desc, [](Desc& d) { d.geometry.vertex_stride = 8; }, RSH_INVALID_VALUE,
                  {"vertex_stride", "8"});
    auto frame = valid_.frame();
    frame.audit_rays = 1;
    refuses<rsh_frame_desc>(frame, [](auto&) {}, RSH_INVALID_VALUE, {"audit", "NULL"});
    refuses<rsh_frame_desc>(frame, [&](auto& d) { d.audit = short_.get(); },
                            RSH_BUFFER_TOO_SMALL, {"audit", "4", "32"});
    refuses<rsh_frame_desc>(frame, [](auto& d) { d.audit = d.colour; }, RSH_INVALID_VALUE,
                            {"audit", "overlap", "colour"});
}

TEST_F(Misuse, OfSpawnAndShadeIsRefused) {
    using Spawn = rsh_spawn_desc;
    using Shade = rsh_shade_desc;
    const auto spawn = valid_.spawn();
    const auto shade = valid_.shade();
    refuses<Spawn>(spawn, [](Spawn& d) { d.kind = 3; }, RSH_INVALID_VALUE, {"kind", "3"});
    refuses<Spawn>(spawn, [](Spawn& d) { d.scene = nullptr; }, RSH_INVALID_VALUE,
                   {"scene", "NULL"});
    refuses<Spawn>(spawn, [](Spawn& d) { d.kind = RSH_SPAWN_SHADOW, d.light = 3; },
                   RSH_INVALID_VALUE, {"light", "3"});
    refuses<Spawn>(spawn, [](Spawn& d) { d.min_weight = -1; }, RSH_INVALID_VALUE,
                   {"min_weight", "-1"});
    refuses<Spawn>(spawn, [](Spawn& d) { d.ray_count = 65; }, RSH_BUFFER_TOO_SMALL,
                   {"rays", "2048", "2080"});
    refuses<Shade>(shade, [](Shade& d) { d.colour = nullptr; }, RSH_INVALID_VALUE,
                   {"colour", "NULL"});
    for (const cl_uint count : {(1u << 28) + 1, 0xffffffffu}) {
        refuses<Spawn>(spawn, [=](Spawn& d) { d.ray_count = count; }, RSH_INVALID_VALUE,
                       {"ray_count", std::to_string(count), "268435456"});
        refuses<Shade>(shade, [=](Shade& d) { d.ray_count = count; }, RSH_INVALID_VALUE,
                       {"ray_count", std::to_string(count), "268435456"});
    }
    refuses<Shade>(shade, [](Shade& d) { d.ray_count = 1u << 28; }, RSH_BUFFER_TOO_SMALL,
                   {"rays", "2048", "8589934592"});
    refuses<Shade>(shade, [&](Shade& d) { d.occlusion = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                   {"occlusion", "4", "256"});
    const cl::Buffer half(test::device().context, CL_MEM_READ_WRITE, 2);
    refuses<Spawn>(spawn, [&](Spawn& d) { d.list_count = half(); }, RSH_BUFFER_TOO_SMALL,
                   {"list_count", "2 bytes", "4"});
    refuses<Shade>(shade, [](Shade& d) { d.list_count = d.colour; }, RSH_INVALID_VALUE,
                   {"colour", "overlap", "list_count"});
}

TEST_F(Misuse, OfWavesIsRefused) {
    using Spawn = rsh_spawn_wave_desc;
    using Gather = rsh_gather_wave_desc;
    const auto spawn = valid_.spawn_wave();
    const auto gather = valid_.gather_wave();
    const auto refuses_both = [&](auto desc) {
        using Desc = decltype(desc);
        refuses<Desc>(desc, [](Desc& d) { d.scene = nullptr; }, RSH_INVALID_VALUE,
                      {"scene", "NULL"});
        refuses<Desc>(desc, [](Desc& d) { d.width = 16385; }, RSH_INVALID_VALUE,
                      {"width", "16385", "16384"});
        refuses<Desc>(desc, [](Desc& d) { d.capacity = (1u << 28) + 1; }, RSH_INVALID_VALUE,
                      {"capacity", "268435457", "268435456"});
        refuses<Desc>(desc, [&](Desc& d) { d.list_count = short_.get(); }, RSH_INVALID_VALUE,
                      {"height", "8", "0 or 1"});
        refuses<Desc>(desc, [](Desc& d) { d.branches = nullptr; }, RSH_INVALID_VALUE,
                      {"branches", "NULL"});
        refuses<Desc>(desc, [&](Desc& d) { d.branches = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                      {"branches", "4", "512"});
        refuses<Desc>(desc, [&](Desc& d) { d.spawned_count = short_.get(); },
                      RSH_BUFFER_TOO_SMALL, {"spawned_count", "4", "8"});
    };
    refuses_both(spawn);
    refuses_both(gather);
    refuses<Spawn>(spawn, [](Spawn& d) { d.min_weight = -1; }, RSH_INVALID_VALUE,
                   {"min_weight", "-1"});
    refuses<Spawn>(spawn, [](Spawn& d) { d.capacity = 65; }, RSH_BUFFER_TOO_SMALL,
                   {"spawned_rays", "2048", "2080"});
    refuses<Spawn>(spawn, [&](Spawn& d) { d.spawned_parents = short_.get(); },
                   RSH_BUFFER_TOO_SMALL, {"spawned_parents", "4", "256"});
    refuses<Spawn>(spawn, [&](Spawn& d) { d.pixels = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                   {"pixels", "4", "256"});
    refuses<Spawn>(spawn, [](Spawn& d) { d.spawned_pixels = d.spawned_skip; },
                   RSH_INVALID_VALUE, {"spawned_pixels", "overlap", "spawned_skip"});
    refuses<Spawn>(spawn, [&](Spawn& d) { d.scratch = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                   {"scratch", "4 bytes"});
    refuses<Gather>(gather, [](Gather& d) { d.colour = d.spawned_colour; }, RSH_INVALID_VALUE,
                    {"colour", "overlap", "spawned_colour"});
    refuses<Gather>(gather, [](Gather& d) { d.capacity = 65; }, RSH_BUFFER_TOO_SMALL,
                    {"spawned_colour", "1024", "1040"});
}

TEST_F(Misuse, OfShadowsIsRefused) {
    using Desc = rsh_shadow_desc;
    const auto desc = valid_.shadow();
    refuses<Desc>(desc, [](Desc& d) { d.scene = nullptr; }, RSH_INVALID_VALUE,
                  {"scene", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.width = 16385; }, RSH_INVALID_VALUE,
                  {"width", "16385", "16384"});
    refuses<Desc>(desc, [](Desc& d) { d.width = 9; }, RSH_BUFFER_TOO_SMALL,
                  {"rays", "2048", "2304"});
    refuses<Desc>(desc, [](Desc& d) { d.hits = nullptr; }, RSH_INVALID_VALUE, {"hits", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.occlusion = nullptr; }, RSH_INVALID_VALUE,
                  {"occlusion", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.occlusion = d.hits; }, RSH_INVALID_VALUE,
                  {"occlusion", "overlap", "hits"});
    refuses<Desc>(desc, [](Desc& d) { d.active_count = d.occlusion; }, RSH_INVALID_VALUE,
                  {"active_count", "overlap", "occlusion"});
    refuses<Desc>(desc, [](Desc& d) { d.engine = 77; }, RSH_INVALID_VALUE, {"engine", "77"});
    refuses<Desc>(desc, [](Desc& d) { d.strategy = 77; }, RSH_INVALID_VALUE,
                  {"strategy", "77"});
    refuses<Desc>(desc, [](Desc& d) { d.budget = 1; }, RSH_INVALID_VALUE, {"budget", "65536"});
    refuses<Desc>(desc, [](Desc& d) { d.engine = RSH_ENGINE_TILES, d.shape = RSH_SHAPE_CONE; },
                  RSH_INVALID_VALUE, {"shape", "cone", "box", "tiles"});
    refuses<Desc>(desc, [&](Desc& d) { d.bounds = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"bounds", "4"});
    refuses<Desc>(desc, [&](Desc& d) { d.scratch = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"scratch", "4 bytes"});
    refuses<Desc>(desc, [&](Desc& d) { d.list_count = short_.get(); }, RSH_INVALID_VALUE,
                  {"height", "8", "0 or 1"});
}

TEST_F(Misuse, OfSurfacesIsRefused) {
    using Desc = rsh_find_surfaces_desc;
    const auto desc = valid_.find_surfaces();
    refuses<Desc>(desc, [](Desc& d) { d.scene = nullptr; }, RSH_INVALID_VALUE,
                  {"scene", "NULL"});
    refuses<Desc>(desc, [](Desc& d) { d.ray_count = (1u << 28) + 1; }, RSH_INVALID_VALUE,
                  {"ray_count", "268435457", "268435456"});
    refuses<Desc>(desc, [](Desc& d) { d.ray_count = 65; }, RSH_BUFFER_TOO_SMALL,
                  {"rays", "2048", "2080"});
    refuses<Desc>(desc, [](Desc& d) { d.surfaces = nullptr; }, RSH_INVALID_VALUE,
                  {"surfaces", "NULL"});
    refuses<Desc>(desc, [&](Desc& d) { d.surfaces = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                  {"surfaces", "4", "5120"});
    refuses<Desc>(desc, [](Desc& d) { d.hits = d.surfaces; }, RSH_INVALID_VALUE,
                  {"surfaces", "overlap", "hits"});
}

TEST_F(Misuse, OfScenesAndFramesIsRefused) {
    using Desc = rsh_frame_desc;
    const auto desc = valid_.frame();
    const auto refuses_scene = [&](const std::function<void(rsh_scene&)>& break_it,
                                   rsh_status status, const std::vector<std::string>& words) {
        rsh_scene scene = valid_.scene.desc;
        break_it(scene);
        refuses<Desc>(
            desc, [&](Desc& d) { d.scene = &scene; }, status, words);
    };
    refuses_scene([](rsh_scene& s) { s.struct_size = 4; }, RSH_INVALID_VALUE,
                  {"scene.struct_size", "4"});
    refuses_scene([](rsh_scene& s) { s.material_count = 0; }, RSH_INVALID_VALUE,
                  {"material_count", "0", "1"});
    refuses_scene([](rsh_scene& s) { s.materials = nullptr; }, RSH_INVALID_VALUE,
                  {"materials", "NULL"});
    refuses_scene([](rsh_scene& s) { s.light_count = 33; }, RSH_INVALID_VALUE,
                  {"light_count", "33", "32"});
    refuses_scene([](rsh_scene& s) { s.lights = nullptr; }, RSH_INVALID_VALUE,
                  {"lights", "NULL"});
    refuses_scene([](rsh_scene& s) { s.features = 0x40; }, RSH_INVALID_VALUE,
                  {"features", "64"});
    refuses_scene([](rsh_scene& s) { s.cut = 3; }, RSH_INVALID_VALUE, {"cut", "3"});
    refuses_scene([](rsh_scene& s) { s.environment_texture = 3; }, RSH_INVALID_VALUE,
                  {"environment_texture", "3"});
    refuses_scene([](rsh_scene& s) { s.normals = nullptr; }, RSH_INVALID_VALUE,
                  {"normals", "NULL"});
    for (const cl_uint stride : {8u, 14u})
        refuses_scene([=](rsh_scene& s) { s.normal_stride = stride; }, RSH_INVALID_VALUE,
                      {"normal_stride", std::to_string(stride), "12"});
    refuses_scene([](rsh_scene& s) { s.normals_offset = 6; }, RSH_INVALID_VALUE,
                  {"normals_offset", "6", "multiple of 4"});
    refuses_scene([](rsh_scene& s) { s.normals_offset = 4; }, RSH_BUFFER_TOO_SMALL,
                  {"scene.normals"});
    refuses_scene([](rsh_scene& s) { s.normals_offset = ~cl_ulong{3}; }, RSH_BUFFER_TOO_SMALL,
                  {"scene.normals"});
    refuses_scene([](rsh_scene& s) { s.normal_stride = 16; }, RSH_BUFFER_TOO_SMALL,
                  {"scene.normals"});
    refuses<Desc>(desc, [](Desc& d) { d.width = 0; }, RSH_INVALID_VALUE, {"width", "0"});
    refuses<Desc>(desc, [](Desc& d) { d.height = 9; }, RSH_BUFFER_TOO_SMALL,
                  {"colour", "1024", "1152"});
    refuses<Desc>(desc, [](Desc& d) { d.bounces = 17; }, RSH_INVALID_VALUE,
                  {"bounces", "17", "16"});
    refuses<Desc>(desc, [](Desc& d) { d.min_weight = NAN; }, RSH_INVALID_VALUE,
                  {"min_weight", "nan"});
    for (const float wrong : {-0.5f, NAN, INFINITY})
        refuses<Desc>(desc, [=](Desc& d) { d.tolerance = wrong; }, RSH_INVALID_VALUE,
                      {"tolerance", "finite, not negative"});
    refuses<Desc>(desc, [](Desc& d) { d.engine = 9; }, RSH_INVALID_VALUE, {"engine", "9"});
    refuses<Desc>(desc, [](Desc& d) { d.budget = 1; }, RSH_INVALID_VALUE, {"budget", "1"});
    refuses<Desc>(desc, [](Desc& d) { d.window.x = 1; }, RSH_INVALID_VALUE,
                  {"window.x", "1", "0"});
    refuses<Desc>(desc,
                  [](Desc& d) {
                      d.window = {0, 3, 8, 10};
                  },
                  RSH_INVALID_VALUE, {"window.y", "3", "2"});
    refuses<Desc>(desc,
                  [](Desc& d) {
                      d.window = {0, 0, 7, 8};
                  },
                  RSH_INVALID_VALUE, {"window.picture_width", "7", "8"});
    refuses<Desc>(desc,
                  [](Desc& d) {
                      d.window = {0, 0, 8, 16385};
                  },
                  RSH_INVALID_VALUE, {"window.picture_height", "16385", "16384"});
}

TEST_F(Misuse, OfQueriesAndContextsIsRefused) {
    rsh_sizes sizes = {};
    auto desc = valid_.reduce();
    EXPECT_EQ(rsh_reduce_query(test::device().rsh, &desc, nullptr), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_reduce_query(test::device().rsh, &desc, &sizes), RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("struct_size"), std::string::npos);

    rsh_context context = nullptr;
    rsh_context_desc create = {};
    create.struct_size = sizeof create;
    EXPECT_EQ(rsh_create_context(nullptr, &context), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_create_context(&create, nullptr), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_create_context(&create, &context), RSH_INVALID_VALUE);
    create.context = test::device().context();
    create.device = test::device().device();
    create.vector_width = 3;
    EXPECT_EQ(rsh_create_context(&create, &context), RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("vector_width"), std::string::npos)
        << rsh_last_error();
    create.vector_width = 0;
    create.max_variants = RSH_MAX_VARIANTS + 1;
    EXPECT_EQ(rsh_create_context(&create, &context), RSH_INVALID_VALUE);
    test::expect_said({"max_variants", "9", "8", "RSH_NO_VARIANTS"});
    EXPECT_EQ(context, nullptr);
    rsh_release_context(nullptr);
}

}  // namespace
