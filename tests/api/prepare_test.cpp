// prepare_test.cpp - rsh_prepare compiles what the calls need, and does nothing else. What OpenCL sees
// of it is counted in support/layers/counts_test.cpp; in the background: device/prepare_test.cpp.
#include <gtest/gtest.h>

#include "api/calls.hpp"
#include "api/valid_calls.hpp"
#include "support/prepare.hpp"

namespace {

using test::device;
using test::prepare_desc;
using test::programs_of;
using Steps = std::vector<std::pair<cl_uint, cl_uint>>;

class Prepare : public ::testing::Test {
protected:
    // That `call` needs no program once `member` of the descriptor has prepared it.
    template <class Desc, class Call>
    void prepares(const char* name, const Desc* rsh_prepare_desc::*member, const Desc& desc,
                  Call call) {
        rsh_prepare_desc prepare = prepare_desc();
        prepare.*member = &desc;
        ASSERT_EQ(rsh_prepare(own_.get(), &prepare), RSH_SUCCESS) << name << rsh_last_error();
        EXPECT_TRUE(valid_.outputs_untouched()) << name;
        const cl_ulong before = programs_of(own_.get());
        ASSERT_EQ(call(own_.get(), device().queue(), &desc, 0, nullptr, nullptr), RSH_SUCCESS)
            << name << ": " << rsh_last_error();
        device().queue.finish();
        EXPECT_EQ(programs_of(own_.get()), before) << name;
        EXPECT_GT(before, 0u) << name;
    }
    void prepares_frame(const char* name, rsh_frame_desc frame, cl_uint engine) {
        frame.engine = engine;
        prepares(name, &rsh_prepare_desc::frame, frame, rsh_frame);
    }

    test::ValidCalls valid_;
    const test::OwnContext own_;
};

TEST_F(Prepare, LeavesNothingToCompileToFrames) {
    rsh_frame_desc frame = valid_.frame();
    frame.bounces = 2;
    const test::Buffer<cl_float4> colour(test::kRays);
    frame.colour = colour.get();
    prepares_frame("tiles", frame, RSH_ENGINE_TILES);
    prepares_frame("paper_faithful", frame, RSH_ENGINE_PAPER_FAITHFUL);
    const test::Buffer<rsh_audit_report> report(1);
    frame.audit_rays = 4;
    frame.audit = report.get();
    prepares_frame("audited", frame, RSH_ENGINE_TILES);
}

TEST_F(Prepare, LeavesNothingToCompileToTheQueriesOfEachEngine) {
    const test::Buffer<rsh_hit> hits(test::kRays);
    const test::Buffer<uint32_t> words(std::vector<uint32_t>(test::kRays, 0));
    for (const cl_uint engine : {RSH_ENGINE_BRUTE_FORCE, RSH_ENGINE_TILES, RSH_ENGINE_PAPER,
                                 RSH_ENGINE_PAPER_FAITHFUL})
        for (const cl_uint query : {RSH_QUERY_CLOSEST, RSH_QUERY_COUNT})
            for (const bool is_masked : {false, true}) {
                rsh_trace_desc trace = valid_.trace();
                trace.engine = engine;
                trace.query = query;
                trace.hits = query == RSH_QUERY_CLOSEST ? hits.get() : nullptr;
                trace.hit_counts = query == RSH_QUERY_COUNT ? words.get() : nullptr;
                trace.ray_masks = is_masked ? valid_.words.get() : nullptr;
                prepares(rsh_engine_name(engine), &rsh_prepare_desc::trace, trace, rsh_trace);
            }
}

// The same file, with and without the filter of masks.
TEST_F(Prepare, TellsTheVariantsOfAProgramApart) {
    const rsh_traverse_desc traverse = valid_.traverse();
    rsh_trace_desc trace = valid_.trace();
    trace.ray_masks = valid_.words.get();
    rsh_prepare_desc prepare = prepare_desc();
    prepare.traverse = &traverse;
    prepare.trace = &trace;
    RSH_CHECK(rsh_prepare(own_.get(), &prepare));
    EXPECT_EQ(programs_of(own_.get()), 2u);
}

TEST_F(Prepare, AsksForNoBuffer) {
    rsh_trace_desc trace = valid_.trace();
    trace.geometry.vertices = trace.geometry.indices = nullptr;
    trace.hits = nullptr;
    rsh_frame_desc frame = valid_.frame();
    frame.colour = nullptr;
    rsh_prepare_desc prepare = prepare_desc();
    prepare.trace = &trace;
    prepare.frame = &frame;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_SUCCESS) << rsh_last_error();
    EXPECT_GT(programs_of(own_.get()), 1u);
}

TEST_F(Prepare, CountsNothingAsDone) {
    rsh_frame_desc frame = valid_.frame();
    frame.bounces = 1;
    rsh_prepare_desc prepare = prepare_desc();
    prepare.frame = &frame;
    RSH_CHECK(rsh_count_statistics(own_.get(), CL_TRUE));
    RSH_CHECK(rsh_prepare(own_.get(), &prepare));
    rsh_statistics sums = {};
    sums.struct_size = sizeof sums;
    RSH_CHECK(rsh_get_statistics(own_.get(), &sums));
    EXPECT_EQ(sums.launches + sums.traversals + sums.host_waits + sums.scratch_bytes, 0u);
}

int note(cl_uint done, cl_uint count, void* user) {
    static_cast<Steps*>(user)->push_back({done, count});
    return 0;
}

int stop_after_one(cl_uint done, cl_uint count, void* user) {
    note(done, count, user);
    return done == 1;
}

int never_called(cl_uint, cl_uint, void*) {
    ADD_FAILURE() << "progress of a call that was not made";
    return 1;
}

TEST_F(Prepare, TellsHowFarItIsAndCanBeStopped) {
    rsh_reduce_desc reduce = valid_.reduce();
    reduce.strategy = RSH_STRATEGY_ATOMIC;
    rsh_traverse_desc traverse = valid_.traverse();
    traverse.progress = never_called;
    Steps steps;
    rsh_prepare_desc prepare = prepare_desc();
    prepare.reduce = &reduce;
    prepare.traverse = &traverse;
    prepare.progress = stop_after_one;
    prepare.progress_user = &steps;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_CANCELLED);
    test::expect_said({"progress", "1", "2"});
    EXPECT_EQ(programs_of(own_.get()), 1u);
    steps.clear();
    prepare.progress = note;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_SUCCESS);
    EXPECT_EQ(steps, (Steps{{0, 2}, {1, 2}, {2, 2}}));
}

TEST_F(Prepare, RefusesWhatTheCallsRefuse) {
    rsh_prepare_desc prepare = prepare_desc();
    EXPECT_EQ(rsh_prepare(nullptr, &prepare), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_wait_prepared(nullptr), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_prepare(own_.get(), nullptr), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_SUCCESS) << "of no call";
    prepare.background = 2;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_INVALID_VALUE);
    test::expect_said({"background", "2", "0 or 1"});
    prepare = prepare_desc();
    prepare.general = 2;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_INVALID_VALUE);
    test::expect_said({"general", "2", "0 or 1"});
    prepare = prepare_desc();
    prepare.struct_size = 1;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_INVALID_VALUE);
    test::expect_said({"struct_size", "1"});
    prepare = prepare_desc();
    rsh_frame_desc frame = valid_.frame();
    frame.struct_size = 3;
    prepare.frame = &frame;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_INVALID_VALUE);
    test::expect_said({"frame.struct_size", "3"});
    frame = valid_.frame();
    frame.width = 0;
    EXPECT_EQ(rsh_prepare(own_.get(), &prepare), RSH_INVALID_VALUE);
    test::expect_said({"width", "0"});
    EXPECT_EQ(programs_of(own_.get()), 0u);
}

}  // namespace
