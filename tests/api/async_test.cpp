// async_test.cpp - events, wait lists, queues, threads and the order of release.
#include <gtest/gtest.h>

#include <thread>

#include "api/valid_calls.hpp"
#include "support/compare.hpp"

namespace {

using test::Device;
using test::device;

cl_int status_of(const cl::Event& event) {
    return event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>();
}

// A call waits for a user event, and its own event ends after everything it enqueued.
void expect_waits(const cl::CommandQueue& queue) {
    const test::ValidCalls valid;
    const rsh_reduce_desc desc = valid.reduce();
    cl::UserEvent gate(device().context);
    const cl_event waits_for = gate();
    cl_event raw = nullptr;
    RSH_CHECK(rsh_reduce(device().rsh, queue(), &desc, 1, &waits_for, &raw));
    ASSERT_NE(raw, nullptr);
    const cl::Event done(raw);
    queue.flush();
    EXPECT_TRUE(valid.packed.untouched()) << "the call did not wait";
    EXPECT_GT(status_of(done), CL_COMPLETE);
    gate.setStatus(CL_COMPLETE);
    done.wait();
    EXPECT_EQ(status_of(done), CL_COMPLETE);
    EXPECT_EQ(valid.count.read()[0], 1024u);
    EXPECT_TRUE(test::same_bits(valid.packed.read(), valid.words.read(), "words"));
    queue.finish();
}

// Build, then traverse, only by events: an out-of-order queue must not mix them up.
std::vector<rsh_hit> trace_by_events(const cl::CommandQueue& queue, rsh_context rsh) {
    const test::ValidCalls valid;
    rsh_build_desc build = valid.build();
    rsh_traverse_desc traverse = valid.traverse();
    traverse.engine = RSH_ENGINE_PAPER_FAITHFUL;
    build.shape = traverse.shape = RSH_SHAPE_CONE;
    traverse.nodes = build.nodes;
    cl_event built = nullptr, traced = nullptr;
    RSH_CHECK(rsh_build(rsh, queue(), &build, 0, nullptr, &built));
    const cl::Event built_event(built);
    RSH_CHECK(rsh_traverse(rsh, queue(), &traverse, 1, &built, &traced));
    const cl::Event traced_event(traced);
    queue.flush();
    traced_event.wait();
    return valid.hits.read();
}

std::vector<rsh_hit> expected_hits() {
    const test::ValidCalls valid;
    return closest_hits(test::DeviceMesh(valid.host.mesh), valid.ray_list);
}

TEST(WaitList, HoldsBackACallOnAnInOrderQueue) {
    expect_waits(cl::CommandQueue(device().context, device().device));
}

TEST(WaitList, HoldsBackACallOnAnOutOfOrderQueue) {
    expect_waits(device().out_of_order_queue());
}

TEST(DoneEvent, OrdersCallsOnAnOutOfOrderQueue) {
    const auto expected = expected_hits();
    const cl::CommandQueue queue = device().out_of_order_queue();
    for (int repeat = 0; repeat < 5; ++repeat)
        EXPECT_TRUE(test::same_bits(trace_by_events(queue, device().rsh), expected, "hits"));
}

// Nothing to do: the event exists all the same, and waits for the wait list.
TEST(DoneEvent, IsValidWhenThereWasNothingToDo) {
    const test::ValidCalls valid;
    rsh_reduce_desc reduce = valid.reduce();
    reduce.count = 0;
    rsh_bound_desc bound = valid.bound();
    bound.geometry.triangle_count = 0;
    rsh_shade_desc shade = valid.shade();
    shade.ray_count = 0;
    for (const cl::CommandQueue& queue : {device().queue, device().out_of_order_queue()}) {
        cl::UserEvent gate(device().context);
        const cl_event waits_for = gate();
        cl_event events[3] = {};
        RSH_CHECK(rsh_reduce(device().rsh, queue(), &reduce, 1, &waits_for, &events[0]));
        RSH_CHECK(rsh_bound(device().rsh, queue(), &bound, 1, &waits_for, &events[1]));
        RSH_CHECK(rsh_shade(device().rsh, queue(), &shade, 1, &waits_for, &events[2]));
        queue.flush();
        for (const cl_event event : events) {
            ASSERT_NE(event, nullptr);
            EXPECT_GT(status_of(cl::Event(event, true)), CL_COMPLETE) << "did not wait";
        }
        gate.setStatus(CL_COMPLETE);
        for (const cl_event event : events) cl::Event(event).wait();
    }
    EXPECT_EQ(valid.count.read()[0], 0u);
    EXPECT_TRUE(valid.packed.untouched());
}

TEST(Threads, TraceOnOneContextSideBySide) {
    const auto expected = expected_hits();
    const test::OwnContext context;  // programs are built while both threads ask for them
    std::vector<rsh_hit> found[4];
    std::vector<std::thread> threads;
    for (auto& hits : found)
        threads.emplace_back([&] {
            const cl::CommandQueue queue(device().context, device().device);
            for (int repeat = 0; repeat < 5; ++repeat)
                hits = trace_by_events(queue, context.get());
        });
    for (std::thread& thread : threads) thread.join();
    for (const auto& hits : found) EXPECT_TRUE(test::same_bits(hits, expected, "hits"));
}

TEST(Threads, HaveAnErrorMessageEach) {
    EXPECT_EQ(rsh_reduce(nullptr, nullptr, nullptr, 0, nullptr, nullptr), RSH_INVALID_VALUE);
    const std::string here = rsh_last_error();
    EXPECT_FALSE(here.empty());
    std::string there = "none";
    std::thread([&] { there = rsh_last_error(); }).join();
    EXPECT_EQ(there, "");
    EXPECT_EQ(rsh_last_error(), here);
}

TEST(Release, WaitsForTheCommandsOfItsCalls) {
    const test::ValidCalls valid;
    const rsh_reduce_desc desc = valid.reduce();
    const cl::CommandQueue queue(device().context, device().device);
    cl_event raw = nullptr;
    {
        const test::OwnContext context;
        RSH_CHECK(rsh_reduce(context.get(), queue(), &desc, 0, nullptr, &raw));
        queue.flush();
    }
    cl::Event(raw).wait();
    EXPECT_EQ(valid.count.read()[0], 1024u);
}

// The context outlives the application's own references to its OpenCL objects.
TEST(Release, MayComeAfterTheCallersReferences) {
    rsh_context context = nullptr;
    {
        const cl::Context own(device().device);
        rsh_context_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.context = own();
        desc.device = device().device();
        RSH_CHECK(rsh_create_context(&desc, &context));
    }
    RSH_CHECK(rsh_count_statistics(context, CL_TRUE));
    rsh_release_context(context);
}

TEST(Progress, CancelsBetweenBatches) {
    const test::ValidCalls valid;
    rsh_frame_desc desc = valid.frame();
    desc.bounces = 2;
    int calls = 0;
    desc.progress_user = &calls;
    desc.progress = [](cl_uint, cl_uint, void* user) {
        return int(++*static_cast<int*>(user) == 2);
    };
    EXPECT_EQ(rsh_frame(device().rsh, device().queue(), &desc, 0, nullptr, nullptr),
              RSH_CANCELLED);
    EXPECT_EQ(calls, 2);
    device().queue.finish();
    RSH_CHECK(rsh_frame(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
    device().queue.finish();
}

}  // namespace
