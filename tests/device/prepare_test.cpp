// prepare_test.cpp - rsh_prepare in the background: on a thread of the context's, beside other calls, with
// a program that does not compile, and when the context goes meanwhile.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <thread>

#include "api/calls.hpp"
#include "api/valid_calls.hpp"
#include "support/changed_kernels.hpp"
#include "support/prepare.hpp"

namespace {

using test::device;
using test::prepare_desc;
using test::programs_of;

class PrepareInBackground : public ::testing::Test {
protected:
    test::ValidCalls valid_;
    const test::OwnContext own_;
};

TEST_F(PrepareInBackground, CompilesOnAThreadOfTheContext) {
    rsh_reduce_desc reduce = valid_.reduce();
    std::vector<std::thread::id> threads;
    rsh_prepare_desc prepare = prepare_desc();
    prepare.reduce = &reduce;
    prepare.background = CL_TRUE;
    prepare.progress = [](cl_uint, cl_uint, void* user) {
        static_cast<std::vector<std::thread::id>*>(user)->push_back(std::this_thread::get_id());
        return 0;
    };
    prepare.progress_user = &threads;
    EXPECT_EQ(rsh_wait_prepared(own_.get()), RSH_SUCCESS) << "there is nothing to wait for";
    for (const cl_uint strategy :
         {RSH_STRATEGY_ATOMIC, RSH_STRATEGY_BLOCK, RSH_STRATEGY_HORN}) {
        reduce.strategy = strategy;
        RSH_CHECK(rsh_prepare(own_.get(), &prepare));
    }
    EXPECT_EQ(rsh_wait_prepared(own_.get()), RSH_SUCCESS) << rsh_last_error();
    const cl_ulong before = programs_of(own_.get());
    EXPECT_GE(before, 3u);
    ASSERT_GE(threads.size(), 6u);
    for (const std::thread::id& thread : threads) EXPECT_NE(thread, std::this_thread::get_id());
    for (const cl_uint strategy :
         {RSH_STRATEGY_ATOMIC, RSH_STRATEGY_BLOCK, RSH_STRATEGY_HORN}) {
        reduce.strategy = strategy;
        RSH_CHECK(rsh_reduce(own_.get(), device().queue(), &reduce, 0, nullptr, nullptr));
    }
    device().queue.finish();
    EXPECT_EQ(programs_of(own_.get()), before);
}

// Calls meanwhile, from two threads, that need the programs which are still to come.
TEST_F(PrepareInBackground, DisturbsNoCallMeanwhile) {
    const rsh_traverse_desc traverse = valid_.traverse();
    const rsh_reduce_desc reduce = valid_.reduce();
    rsh_prepare_desc prepare = prepare_desc();
    prepare.traverse = &traverse;
    prepare.reduce = &reduce;
    prepare.background = CL_TRUE;
    RSH_CHECK(rsh_prepare(own_.get(), &prepare));
    std::future<rsh_status> other = std::async(std::launch::async, [&] {
        return rsh_reduce(own_.get(), device().queue(), &reduce, 0, nullptr, nullptr);
    });
    RSH_CHECK(rsh_traverse(own_.get(), device().queue(), &traverse, 0, nullptr, nullptr));
    EXPECT_EQ(other.get(), RSH_SUCCESS);
    device().queue.finish();
    RSH_CHECK(rsh_wait_prepared(own_.get()));
    EXPECT_EQ(valid_.count.read()[0], 1024u);
    EXPECT_EQ(programs_of(own_.get()), 2u) << "each is compiled once";
}

struct Gate {
    std::promise<void> is_in_progress;
    std::shared_future<void> may_go_on;
    std::atomic<int> calls{0};
};

int hold_the_first(cl_uint, cl_uint, void* user) {
    Gate& gate = *static_cast<Gate*>(user);
    if (++gate.calls > 1) return 0;
    gate.is_in_progress.set_value();
    gate.may_go_on.wait();
    return 0;
}

// While the thread is held, release waits for it; what was to come after is left out.
TEST(PrepareInBackgroundOfAContext, WaitsWhenReleasedForTheProgramUnderWayAlone) {
    const test::ValidCalls valid;
    Gate gate;
    std::promise<void> go_on;
    gate.may_go_on = go_on.get_future().share();
    std::future<void> released;
    {
        auto own = std::make_unique<test::OwnContext>();
        const rsh_reduce_desc reduce = valid.reduce();
        const rsh_frame_desc frame = valid.frame();
        rsh_prepare_desc prepare = prepare_desc();
        prepare.reduce = &reduce;
        prepare.frame = &frame;
        prepare.background = CL_TRUE;
        prepare.progress = hold_the_first;
        prepare.progress_user = &gate;
        RSH_CHECK(rsh_prepare(own->get(), &prepare));
        gate.is_in_progress.get_future().wait();
        released = std::async(std::launch::async, [&own] { own.reset(); });
        EXPECT_EQ(released.wait_for(std::chrono::seconds(1)), std::future_status::timeout);
        go_on.set_value();
        released.wait();
    }
    EXPECT_EQ(gate.calls, 1) << "programs were compiled for nobody";
}

TEST(PrepareInBackgroundOfAContext, TellsWhatDoesNotCompileAndSoDoesTheCall) {
    const test::ChangedKernels broken("traverse/brute_force.cl",
                                      "__kernel void rsh_brute_force",
                                      "this is no OpenCL C; __kernel void rsh_brute_force");
    const test::ValidCalls valid;
    const rsh_traverse_desc traverse = valid.traverse();
    const rsh_reduce_desc reduce = valid.reduce();
    rsh_prepare_desc prepare = prepare_desc();
    prepare.traverse = &traverse;
    prepare.reduce = &reduce;
    EXPECT_EQ(rsh_prepare(broken.context(), &prepare), RSH_BUILD_FAILED);
    test::expect_said({"traverse/brute_force"});
    prepare.background = CL_TRUE;
    RSH_CHECK(rsh_prepare(broken.context(), &prepare));
    EXPECT_EQ(rsh_wait_prepared(broken.context()), RSH_BUILD_FAILED);
    test::expect_said({"traverse/brute_force"});
    EXPECT_EQ(rsh_wait_prepared(broken.context()), RSH_SUCCESS) << "it is told once";
    const auto queue = device().queue();
    EXPECT_EQ(rsh_traverse(broken.context(), queue, &traverse, 0, nullptr, nullptr),
              RSH_BUILD_FAILED);
    const cl_ulong before = programs_of(broken.context());
    RSH_CHECK(rsh_reduce(broken.context(), queue, &reduce, 0, nullptr, nullptr));
    device().queue.finish();
    EXPECT_EQ(programs_of(broken.context()), before) << "the other program was compiled";
}

}  // namespace
