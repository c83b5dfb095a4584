// trace_misuse_test.cpp - rsh_trace with a wrong argument: the status of rsh.h, a message with the field, the
// actual and the required value, and nothing is enqueued.
#include <gtest/gtest.h>

#include <functional>

#include "api/calls.hpp"
#include "api/valid_calls.hpp"
#include "support/ways.hpp"

namespace {

using test::call;
using test::kRays;
using Desc = rsh_trace_desc;

class MisuseOfTrace : public ::testing::Test {
protected:
    void refuses(Desc desc, const std::function<void(Desc&)>& break_it, rsh_status status,
                 const std::vector<std::string>& words) {
        break_it(desc);
        cl_event event = nullptr;
        EXPECT_EQ(call(&desc, &event), status) << words[0] << ": " << rsh_last_error();
        EXPECT_EQ(event, nullptr) << words[0];
        test::expect_said(words);
        EXPECT_TRUE(valid_.outputs_untouched()) << words[0];
    }
    void refuses(const std::function<void(Desc&)>& break_it,
                 const std::vector<std::string>& words) {
        refuses(valid_.trace(), break_it, RSH_INVALID_VALUE, words);
    }

    // Rays in arrays.
    Desc apart() const {
        Desc desc = valid_.trace();
        desc.rays = nullptr;
        desc.origins.buffer = desc.directions.buffer = three_.get();
        desc.tmin.buffer = desc.tmax.buffer = one_.get();
        return desc;
    }

    void refuses_floats(rsh_ray_floats Desc::*floats, const std::string& name, cl_uint bytes) {
        const auto refuses_part = [&](const std::function<void(rsh_ray_floats&)>& break_it,
                                      rsh_status status, std::vector<std::string> words) {
            words.insert(words.begin(), name);
            refuses(
                apart(), [&](Desc& d) { break_it(d.*floats); }, status, words);
        };
        refuses_part([](auto& f) { f.offset = 2; }, RSH_INVALID_VALUE, {".offset", "2", "4"});
        refuses_part([=](auto& f) { f.stride = bytes + 2; }, RSH_INVALID_VALUE,
                     {".stride", std::to_string(bytes + 2)});
        refuses_part([=](auto& f) { f.stride = bytes - 1; }, RSH_INVALID_VALUE,
                     {".stride", std::to_string(bytes - 1), std::to_string(bytes)});
        refuses_part([](auto& f) { f.reserved = 9; }, RSH_INVALID_VALUE, {".reserved", "9"});
        const std::string all = std::to_string(bytes * kRays);
        refuses_part([](auto& f) { f.offset = 4; }, RSH_BUFFER_TOO_SMALL,
                     {".buffer", all, std::to_string(bytes * kRays + 4)});
        refuses_part([](auto& f) { f.offset = ~cl_ulong{3}; }, RSH_BUFFER_TOO_SMALL,
                     {".buffer", all});
        refuses_part([=](auto& f) { f.stride = bytes + 4; }, RSH_BUFFER_TOO_SMALL,
                     {".buffer", all, std::to_string((bytes + 4) * (kRays - 1) + bytes)});
        refuses_part([](auto& f) { f.stride = 0xfffffffcu; }, RSH_BUFFER_TOO_SMALL,
                     {".buffer", all});
        refuses_part([this](auto& f) { f.buffer = foreign_(); }, RSH_INVALID_VALUE,
                     {".buffer", "context"});
        refuses(apart(), [&](Desc& d) { d.hits = (d.*floats).buffer = whole_(); },
                RSH_INVALID_VALUE, {"hits", "overlap", name + ".buffer"});
        refuses([&](Desc& d) { (d.*floats).buffer = one_.get(); },
                {name + ".buffer", "NULL with rays"});
    }

    test::ValidCalls valid_;
    const test::Buffer<float> three_{3 * kRays}, one_{kRays};
    const test::Buffer<uint32_t> short_{1};
    const cl::Context other_{test::device().device};
    const cl::Buffer foreign_{other_, CL_MEM_READ_WRITE, 65536};
    const cl::Buffer whole_{test::device().context, CL_MEM_READ_WRITE, 1u << 20};
};

TEST_F(MisuseOfTrace, OfChoicesIsRefused) {
    refuses([](Desc& d) { d.engine = 77; }, {"engine", "77"});
    refuses([](Desc& d) { d.strategy = 77; }, {"strategy", "77"});
    refuses([](Desc& d) { d.query = 77; }, {"query", "77"});
    refuses([](Desc& d) { d.cull = 3; }, {"cull", "3", "RSH_CULL_"});
    refuses([](Desc& d) { d.converging = 2; }, {"converging", "2", "0 or 1"});
    refuses([](Desc& d) { d.budget = RSH_MIN_BUDGET - 1; }, {"budget", "65535", "65536"});
    refuses([](Desc& d) { d.width = 16385; }, {"width", "16385", "16384"});
    refuses([](Desc& d) { d.height = 16385; }, {"height", "16385", "16384"});
    refuses([](Desc& d) { d.geometry.vertex_stride = 8; }, {"vertex_stride", "8", "12"});
}

TEST_F(MisuseOfTrace, OfRaysIsRefused) {
    refuses_floats(&Desc::origins, "origins", 12);
    refuses_floats(&Desc::directions, "directions", 12);
    refuses_floats(&Desc::tmin, "tmin", 4);
    refuses_floats(&Desc::tmax, "tmax", 4);
    refuses([](Desc& d) { d.rays = nullptr; }, {"rays", "origins.buffer", "NULL"});
    refuses(apart(), [](Desc& d) { d.directions.buffer = nullptr; }, RSH_INVALID_VALUE,
            {"directions.buffer", "NULL"});
    refuses(valid_.trace(), [](Desc& d) { d.width = 9; }, RSH_BUFFER_TOO_SMALL,
            {"rays", "2048", "2304"});
}

TEST_F(MisuseOfTrace, OfListCountsAndSkipIsRefused) {
    refuses([this](Desc& d) { d.list_count = short_.get(); },
            {"height", "8", "0 or 1", "list_count"});
    Desc list = valid_.trace();
    list.width = kRays;
    list.height = 1;
    refuses(list, [this](Desc& d) { d.list_count = foreign_(); }, RSH_INVALID_VALUE,
            {"list_count", "context"});
    refuses(list, [](Desc& d) { d.list_count = d.hits; }, RSH_INVALID_VALUE,
            {"hits", "overlap", "list_count"});
    refuses(list, [this](Desc& d) { d.skip = short_.get(); }, RSH_BUFFER_TOO_SMALL,
            {"skip", "4", "256"});
    refuses(list, [this](Desc& d) { d.ray_masks = short_.get(); }, RSH_BUFFER_TOO_SMALL,
            {"ray_masks", "4", "256"});
    refuses(list, [this](Desc& d) { d.ray_masks = foreign_(); }, RSH_INVALID_VALUE,
            {"ray_masks", "context"});
    refuses(list, [](Desc& d) { d.ray_masks = d.hits; }, RSH_INVALID_VALUE,
            {"hits", "overlap", "ray_masks"});
}

TEST_F(MisuseOfTrace, OfAnswersIsRefused) {
    refuses([](Desc& d) { d.hits = nullptr; }, {"hits", "NULL"});
    refuses([](Desc& d) { d.query = RSH_QUERY_ANY; }, {"occlusion", "NULL"});
    Desc any = valid_.trace();
    any.query = RSH_QUERY_ANY;
    any.occlusion = valid_.occlusion.get();
    refuses(any, [](Desc& d) { d.occlusion_bit = 32; }, RSH_INVALID_VALUE,
            {"occlusion_bit", "32"});
    refuses(any, [this](Desc& d) { d.normals = whole_(); }, RSH_INVALID_VALUE,
            {"normals", "NULL with a query that lists no hits"});
    refuses(any, [this](Desc& d) { d.points = whole_(); }, RSH_INVALID_VALUE,
            {"points", "NULL with a query that lists no hits"});
    refuses(any, [this](Desc& d) { d.geometry_ids = whole_(); }, RSH_INVALID_VALUE,
            {"geometry_ids", "NULL with a query that lists no hits"});
    refuses([](Desc& d) { d.query = RSH_QUERY_COUNT; }, {"hit_counts", "NULL"});
    refuses([](Desc& d) { d.query = RSH_QUERY_COUNT, d.normals = d.rays; },
            {"normals", "NULL with a query that lists no hits"});
    Desc all = valid_.trace();
    all.query = RSH_QUERY_ALL;
    all.hit_capacity = 10;
    refuses(all, [](Desc&) {}, RSH_INVALID_VALUE, {"hit_offsets", "NULL"});
    all.hit_offsets = whole_();
    refuses(all, [](Desc& d) { d.hit_capacity = (1ull << 31) + 1; }, RSH_INVALID_VALUE,
            {"hit_capacity", "2147483649", "2147483648"});
    refuses(all, [this](Desc& d) { d.normals = short_.get(); }, RSH_BUFFER_TOO_SMALL,
            {"normals", "4", "120"});
    refuses(all, [this](Desc& d) { d.points = short_.get(); }, RSH_BUFFER_TOO_SMALL,
            {"points", "4", "120"});
    refuses(all, [this](Desc& d) { d.geometry_ids = short_.get(); }, RSH_BUFFER_TOO_SMALL,
            {"geometry_ids", "4", "40"});
    refuses(valid_.trace(), [this](Desc& d) { d.normals = short_.get(); }, RSH_BUFFER_TOO_SMALL,
            {"normals", "4", "768"});
    refuses(valid_.trace(), [this](Desc& d) { d.geometry_ids = short_.get(); },
            RSH_BUFFER_TOO_SMALL, {"geometry_ids", "4", "256"});
    refuses([](Desc& d) { d.normals = d.hits; }, {"normals", "overlap", "hits"});
    refuses([](Desc& d) { d.points = d.hits; }, {"points", "overlap", "hits"});
    refuses([](Desc& d) { d.geometry_ids = d.rays; }, {"geometry_ids", "overlap", "rays"});
}

TEST_F(MisuseOfTrace, OfBoundsAndScratchIsRefused) {
    for (const test::TraceOptions& way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        Desc desc = valid_.trace();
        desc.engine = way.engine;
        refuses(desc, [this](Desc& d) { d.bounds = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                {"bounds", "4"});
        refuses(desc, [this](Desc& d) { d.scratch = short_.get(); }, RSH_BUFFER_TOO_SMALL,
                {"scratch", "4 bytes"});
    }
}

TEST_F(MisuseOfTrace, IsRefusedByTheQueryAsWell) {
    Desc desc = valid_.trace();
    desc.converging = 2;
    rsh_sizes sizes = {sizeof sizes, 11, 22};
    EXPECT_EQ(rsh_trace_query(test::device().rsh, &desc, &sizes), RSH_INVALID_VALUE);
    EXPECT_EQ(sizes.output_bytes, 11u);
    EXPECT_EQ(sizes.scratch_bytes, 22u);
}

}  // namespace
