// skip_test.cpp - the buffers that name the triangles that rays left, given wrongly: the status of
// rsh.h, a message with the field, the actual and the required value, and nothing is enqueued.
#include <gtest/gtest.h>

#include "api/calls.hpp"
#include "api/valid_calls.hpp"
#include "support/ways.hpp"

namespace {

using test::call;
using test::device;
using test::kRays;

class Skip : public ::testing::Test {
protected:
    // Every word must appear in the message.
    template <class Desc>
    void refuses(const Desc& desc, rsh_status status, const std::vector<std::string>& words) {
        EXPECT_EQ(call(&desc), status) << rsh_last_error();
        test::expect_said(words);
        EXPECT_TRUE(valid_.outputs_untouched()) << words[0];
    }

    // A buffer that is one word short, of another context, no buffer at all, or that the call
    // writes as `output`.
    template <class Desc>
    void refuses_wrong_buffers(const Desc& valid, cl_mem Desc::*member, const char* name,
                               cl_mem Desc::*output, const char* output_name) {
        Desc desc = valid;
        desc.*member = short_.get();
        refuses(desc, RSH_BUFFER_TOO_SMALL,
                {name, std::to_string(4 * (kRays - 1)), std::to_string(4 * kRays)});
        const cl::Context other(device().device);
        const cl::Buffer foreign(other, CL_MEM_READ_WRITE, 65536);
        desc.*member = foreign();
        refuses(desc, RSH_INVALID_VALUE, {name, "context"});
        desc.*member = desc.*output = whole_();
        refuses(desc, RSH_INVALID_VALUE, {name, "overlap", output_name});
    }

    test::ValidCalls valid_;
    test::Buffer<uint32_t> short_{kRays - 1};
    cl::Buffer whole_{device().context, CL_MEM_READ_WRITE, 1u << 20};
};

TEST_F(Skip, OfTraversalsIsCheckedForEveryEngine) {
    const test::Buffer<uint8_t> nodes(1u << 20), bounds(1u << 20);
    for (const test::TraceOptions& way : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(way));
        auto desc = valid_.traverse();
        desc.engine = way.engine;
        desc.shape = way.bound;
        desc.nodes = nodes.get();
        desc.bounds = bounds.get();
        refuses_wrong_buffers(desc, &rsh_traverse_desc::skip, "skip", &rsh_traverse_desc::hits,
                              "hits");
    }
}

// Those that say what rays see are buffers of the same kind.
TEST_F(Skip, AndWhatRaysSeeIsChecked) {
    refuses_wrong_buffers(valid_.traverse(), &rsh_traverse_desc::ray_masks, "ray_masks",
                          &rsh_traverse_desc::hits, "hits");
    refuses_wrong_buffers(valid_.audit(), &rsh_audit_desc::ray_masks, "ray_masks",
                          &rsh_audit_desc::report, "report");
    auto traverse = valid_.traverse();
    traverse.cull = 3;
    refuses(traverse, RSH_INVALID_VALUE, {"cull", "3", "RSH_CULL_"});
    auto audit = valid_.audit();
    audit.cull = ~0u;
    refuses(audit, RSH_INVALID_VALUE, {"cull", "4294967295", "RSH_CULL_"});
}

TEST_F(Skip, OfShadowsIsChecked) {
    auto desc = valid_.traverse();
    desc.query = RSH_QUERY_ANY;
    desc.hits = nullptr;
    desc.occlusion = valid_.occlusion.get();
    refuses_wrong_buffers(desc, &rsh_traverse_desc::skip, "skip", &rsh_traverse_desc::occlusion,
                          "occlusion");
}

TEST_F(Skip, OfAuditsIsChecked) {
    refuses_wrong_buffers(valid_.audit(), &rsh_audit_desc::skip, "skip",
                          &rsh_audit_desc::report, "report");
}

TEST_F(Skip, OfSpawnedRaysIsCheckedForEveryKind) {
    for (const cl_uint kind : {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION, RSH_SPAWN_SHADOW}) {
        SCOPED_TRACE("kind " + std::to_string(kind));
        auto desc = valid_.spawn();
        desc.kind = kind;
        refuses_wrong_buffers(desc, &rsh_spawn_desc::spawned_skip, "spawned_skip",
                              &rsh_spawn_desc::spawned_rays, "spawned_rays");
        desc.spawned_skip = desc.hits;
        refuses(desc, RSH_INVALID_VALUE, {"spawned_skip", "overlap", "hits"});
        desc.spawned_skip = desc.scene->geometry.vertices;
        refuses(desc, RSH_INVALID_VALUE, {"spawned_skip", "overlap", "geometry.vertices"});
    }
    auto desc = valid_.spawn();
    desc.spawned_skip = desc.spawned_weights;
    refuses(desc, RSH_INVALID_VALUE, {"spawned_weights", "overlap", "spawned_skip"});
}

// A traversal only reads it: it may be what else the call reads.
TEST_F(Skip, MayBeAnInputAsWell) {
    auto desc = valid_.traverse();
    desc.skip = desc.rays;
    EXPECT_EQ(call(&desc), RSH_SUCCESS) << rsh_last_error();
    device().queue.finish();
}

}  // namespace
