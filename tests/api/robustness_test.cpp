// robustness_test.cpp - calls that other calls, threads, a release or a failure come in between
// of. A gate is an event that the application sets: what waits for it is under way until then.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <thread>

#include "api/valid_calls.hpp"
#include "rays/levels.hpp"
#include "support/compare.hpp"

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::device;

constexpr seconds kPatience{20};

// A traversal by pairs, which takes scratch and reads counts back, over buffers of its own.
class PairTraversal {
public:
    PairTraversal() {
        rsh_build_desc build = valid_.build();
        build.shape = RSH_SHAPE_CONE;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_build_query(device().rsh, &build, &sizes));
        levels = rsh::cone_levels(build.width, build.height);
        RSH_CHECK(rsh_build(device().rsh, device().queue(), &build, 0, nullptr, nullptr));
        device().queue.finish();
        desc = valid_.traverse();
        desc.engine = RSH_ENGINE_PAPER_FAITHFUL;
        desc.shape = RSH_SHAPE_CONE;
        desc.nodes = build.nodes;
    }

    cl::Event enqueue(const test::OwnContext& context, const cl::CommandQueue& queue,
                      const cl::Event& wait = {}) const {
        cl_event done = nullptr;
        RSH_CHECK(rsh_traverse(context.get(), queue(), &desc, wait() ? 1 : 0,
                               wait() ? &wait() : nullptr, &done));
        return cl::Event(done);
    }

    std::vector<rsh_hit> hits() const { return valid_.hits.read(); }

    rsh_traverse_desc desc = {};
    ray_levels levels = {};

private:
    const test::ValidCalls valid_;
};

cl::CommandQueue new_queue() {
    return {device().context, device().device};
}

// Polls: waiting for what never ends would hang the test.
bool ends(const cl::CommandQueue& queue, const cl::Event& event) {
    queue.flush();
    const auto give_up = std::chrono::steady_clock::now() + kPatience;
    while (event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() > CL_COMPLETE) {
        if (std::chrono::steady_clock::now() > give_up) return false;
        std::this_thread::sleep_for(milliseconds(5));
    }
    return true;
}

rsh_statistics statistics_of(const test::OwnContext& context) {
    rsh_statistics sums = {};
    sums.struct_size = sizeof sums;
    RSH_CHECK(rsh_get_statistics(context.get(), &sums));
    return sums;
}

// The memory that the counts were to be read to is not given to others before they arrived.
TEST(Release, LeavesTheMemoryToACountThatIsStillRead) {
    const PairTraversal traversal;
    const cl::CommandQueue queue = new_queue();
    cl::UserEvent gate(device().context);
    {
        const test::OwnContext context;
        RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
        traversal.enqueue(context, queue, gate);
        queue.flush();
    }
    const std::vector<cl_uint> canary(traversal.levels.count, 0xa5a5a5a5u);
    const std::vector<std::vector<cl_uint>> others(256, canary);
    gate.setStatus(CL_COMPLETE);
    queue.finish();
    for (const std::vector<cl_uint>& other : others) ASSERT_EQ(other, canary);
}

TEST(CountStatistics, DropsWhatIsUnderWayWithoutWaitingForIt) {
    const PairTraversal traversal;
    const cl::CommandQueue queue = new_queue();
    const test::OwnContext context;
    cl::UserEvent gate(device().context);
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    traversal.enqueue(context, queue, gate);
    auto again = std::async(std::launch::async,
                            [&] { return rsh_count_statistics(context.get(), CL_TRUE); });
    EXPECT_EQ(again.wait_for(kPatience), std::future_status::ready) << "it waits";
    gate.setStatus(CL_COMPLETE);
    EXPECT_EQ(again.get(), RSH_SUCCESS);
    queue.finish();
    EXPECT_EQ(statistics_of(context).launches, 0u);
    EXPECT_EQ(statistics_of(context).batches, 0u);
}

TEST(GetStatistics, MissesNothingThatIsEnqueuedMeanwhile) {
    constexpr cl_uint kRuns = 100;
    const PairTraversal traversal;
    const cl::CommandQueue queue = new_queue();
    const test::OwnContext context;
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    traversal.enqueue(context, queue);
    const rsh_statistics one = statistics_of(context);
    ASSERT_GT(one.pairs_tested[0], 0u);
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    std::atomic<bool> running{true};
    std::thread reader([&] {
        while (running) statistics_of(context);
    });
    for (cl_uint run = 0; run < kRuns; ++run) traversal.enqueue(context, queue);
    running = false;
    reader.join();
    const rsh_statistics all = statistics_of(context);
    EXPECT_EQ(all.traversals, kRuns * one.traversals);
    EXPECT_EQ(all.launches, kRuns * one.launches);
    EXPECT_EQ(all.batches, kRuns * one.batches);
    EXPECT_EQ(all.peak_pairs, one.peak_pairs);
    for (cl_uint level = 0; level <= traversal.levels.count; ++level)
        EXPECT_EQ(all.pairs_tested[level], kRuns * one.pairs_tested[level])
            << "level " << level;
}

TEST(GetStatistics, BlocksNoCallOfAnotherThread) {
    const PairTraversal held, other;
    const cl::CommandQueue held_queue = new_queue(), other_queue = new_queue();
    const test::OwnContext context;
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    cl::UserEvent gate(device().context);
    held.enqueue(context, held_queue, gate);
    auto sum = std::async(std::launch::async, [&] { return statistics_of(context); });
    EXPECT_EQ(sum.wait_for(milliseconds(200)), std::future_status::timeout) << "did not wait";
    auto call = std::async(std::launch::async, [&] { other.enqueue(context, other_queue); });
    EXPECT_EQ(call.wait_for(kPatience), std::future_status::ready) << "the call waits";
    gate.setStatus(CL_COMPLETE);
    call.get();
    EXPECT_GT(sum.get().batches, 0u);
    EXPECT_EQ(statistics_of(context).traversals, 2u);
    held_queue.finish();
}

TEST(Scratch, OfThePoolMakesNoQueueWaitForAnother) {
    const PairTraversal first, second;
    const cl::CommandQueue first_queue = new_queue(), second_queue = new_queue();
    const test::OwnContext context;
    cl::UserEvent gate(device().context);
    const cl::Event held = first.enqueue(context, first_queue, gate);
    const cl::Event free = second.enqueue(context, second_queue);
    EXPECT_TRUE(ends(second_queue, free)) << "it waits for the other queue's gate";
    gate.setStatus(CL_COMPLETE);
    EXPECT_TRUE(ends(first_queue, held));
    second_queue.finish();
    EXPECT_TRUE(test::same_bits(first.hits(), second.hits(), "hits"));
}

TEST(Scratch, OfThePoolMakesNoCallWaitForAnotherOnAnOutOfOrderQueue) {
    const PairTraversal first, second;
    const cl::CommandQueue queue = device().out_of_order_queue();
    if (!(queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE))
        GTEST_SKIP() << "the device runs every queue in order";
    const test::OwnContext context;
    cl::UserEvent gate(device().context);
    const cl::Event held = first.enqueue(context, queue, gate);
    EXPECT_TRUE(ends(queue, second.enqueue(context, queue))) << "it waits for the other call";
    gate.setStatus(CL_COMPLETE);
    EXPECT_TRUE(ends(queue, held));
    EXPECT_TRUE(test::same_bits(first.hits(), second.hits(), "hits"));
}

// Calls in a row, none of which has ended, share one block: by the queue's order or by events.
TEST(Scratch, OfThePoolDoesNotGrowWithTheCallsUnderWay) {
    const PairTraversal traversal;
    for (const cl::CommandQueue& queue : {new_queue(), device().out_of_order_queue()}) {
        const test::OwnContext context;
        cl::UserEvent gate(device().context);
        cl::Event last = traversal.enqueue(context, queue, gate);
        const cl_ulong bytes = statistics_of(context).scratch_bytes;
        EXPECT_GT(bytes, 0u);
        for (int call = 0; call < 10; ++call) last = traversal.enqueue(context, queue, last);
        EXPECT_EQ(statistics_of(context).scratch_bytes, bytes);
        gate.setStatus(CL_COMPLETE);
        EXPECT_TRUE(ends(queue, last));
        traversal.enqueue(context, queue).wait();
        EXPECT_EQ(statistics_of(context).scratch_bytes, bytes);
    }
}

int cancel_second_batch(cl_uint batch, cl_uint, void*) {
    return batch == 1;
}

// The first batch is enqueued and uses the caller's buffers.
TEST(DoneEvent, EndsAfterTheCommandsOfACallThatWasCancelled) {
    test::Random random(1);
    const test::DeviceMesh mesh(test::random_soup(random, 2000));
    PairTraversal traversal;
    traversal.desc.geometry = mesh.geometry();
    traversal.desc.budget = RSH_MIN_BUDGET;
    traversal.desc.progress = cancel_second_batch;
    const cl::CommandQueue queue = new_queue();
    cl::UserEvent gate(device().context);
    cl_event raw = nullptr;
    EXPECT_EQ(rsh_traverse(device().rsh, queue(), &traversal.desc, 1, &gate(), &raw),
              RSH_CANCELLED);
    queue.flush();
    const cl::Event done(raw);
    const bool too_early =
        raw && done.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE;
    gate.setStatus(CL_COMPLETE);
    queue.finish();
    ASSERT_NE(raw, nullptr);
    EXPECT_FALSE(too_early);
    EXPECT_TRUE(ends(queue, done));
}

// Out of a C function's callback no exception should come; one that does goes no further.
TEST(Callback, ThatThrowsEndsItsCallAlone) {
    const test::ValidCalls valid;
    rsh_context_desc own = {};
    own.struct_size = sizeof own;
    own.context = device().context();
    own.device = device().device();
    bool throws = true;
    own.log_user = &throws;
    own.log = [](const char*, void* user) {
        if (*static_cast<bool*>(user)) throw std::runtime_error("the log is full");
    };
    rsh_context context = nullptr;
    RSH_CHECK(rsh_create_context(&own, &context));
    const rsh_reduce_desc reduce = valid.reduce();
    EXPECT_EQ(rsh_reduce(context, device().queue(), &reduce, 0, nullptr, nullptr),
              RSH_INTERNAL_ERROR);
    EXPECT_STREQ(rsh_last_error(), "the log is full");
    throws = false;
    EXPECT_EQ(rsh_reduce(context, device().queue(), &reduce, 0, nullptr, nullptr), RSH_SUCCESS)
        << rsh_last_error();
    rsh_frame_desc frame = valid.frame();
    frame.bounces = 2;
    frame.progress = [](cl_uint, cl_uint, void*) -> int { throw 7; };
    EXPECT_EQ(rsh_frame(context, device().queue(), &frame, 0, nullptr, nullptr),
              RSH_INTERNAL_ERROR);
    device().queue.finish();
    frame.progress = nullptr;
    EXPECT_EQ(rsh_frame(context, device().queue(), &frame, 0, nullptr, nullptr), RSH_SUCCESS);
    device().queue.finish();
    rsh_release_context(context);
}

TEST(DoneEvent, IsNullWhenNothingWasEnqueued) {
    const test::ValidCalls valid;
    rsh_reduce_desc desc = valid.reduce();
    desc.input = nullptr;
    const cl::UserEvent before(device().context);
    for (const rsh_context context : {device().rsh, rsh_context(nullptr)}) {
        cl_event done = before();
        EXPECT_EQ(rsh_reduce(context, device().queue(), &desc, 0, nullptr, &done),
                  RSH_INVALID_VALUE);
        EXPECT_EQ(done, nullptr);
    }
}

}  // namespace
