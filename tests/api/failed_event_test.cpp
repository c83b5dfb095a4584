// failed_event_test.cpp - events that fail, before a call waits for them or while it does: the call
// says so, and soon. What never ends must not hang the test, so that calls are watched.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <future>
#include <thread>

#include "api/valid_calls.hpp"
#include "support/random.hpp"

namespace {

using std::chrono::milliseconds;
using test::device;
using test::ValidCalls;

constexpr milliseconds kLater{200}, kSoon{1000}, kPatience{20000};

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

// What the call returns, and its message. A call that hangs ends the program.
struct Outcome {
    rsh_status status;
    std::string message;
    double took_ms;
};
Outcome watched(const std::function<rsh_status()>& call) {
    const auto start = std::chrono::steady_clock::now();
    auto outcome = std::async(std::launch::async, [&]() -> Outcome {
        const rsh_status status = call();
        return {status, rsh_last_error(), milliseconds_since(start)};
    });
    if (outcome.wait_for(kPatience) == std::future_status::timeout) {
        std::fprintf(stderr, "%s hangs\n",
                     testing::UnitTest::GetInstance()->current_test_info()->name());
        std::_Exit(1);
    }
    return outcome.get();
}

// The calls that take a wait list, over buffers of their own.
class WaitingCalls {
public:
    using Call =
        std::function<rsh_status(cl_command_queue, cl_uint, const cl_event*, cl_event*)>;

    struct Named {
        const char* name;
        Call call;
    };
    std::vector<Named> all() const {
        return {{"rsh_rasterize", of(rsh_rasterize, valid.rasterize())},
                {"rsh_bound", bound()},
                {"rsh_build", of(rsh_build, valid.build())},
                {"rsh_traverse", of(rsh_traverse, valid.traverse())},
                {"rsh_trace", of(rsh_trace, valid.trace())},
                {"rsh_audit", of(rsh_audit, valid.audit())},
                {"rsh_spawn", of(rsh_spawn, valid.spawn())},
                {"rsh_spawn_wave", of(rsh_spawn_wave, valid.spawn_wave())},
                {"rsh_gather_wave", of(rsh_gather_wave, valid.gather_wave())},
                {"rsh_shadow", of(rsh_shadow, valid.shadow())},
                {"rsh_find_surfaces", of(rsh_find_surfaces, valid.find_surfaces())},
                {"rsh_shade", of(rsh_shade, valid.shade())},
                {"rsh_frame", of(rsh_frame, valid.frame())},
                {"rsh_frame with bounces", frame()},
                {"rsh_frame with bounces, approximate", approximate_frame()},
                {"rsh_frame with bounces, of batches", of(rsh_frame, valid.frame_batches())},
                {"rsh_trace of batches", of(rsh_trace, valid.trace_batches())},
                {"rsh_reduce", of(rsh_reduce, valid.reduce())}};
    }
    Call bound() const {
        rsh_bound_desc desc = valid.bound();
        desc.bounds = bounds.get();
        return of(rsh_bound, desc);
    }
    Call frame() const {
        rsh_frame_desc desc = valid.frame();
        desc.bounces = 2;
        return of(rsh_frame, desc);
    }
    Call approximate_frame() const {
        rsh_frame_desc desc = valid.frame();
        desc.bounces = 1;
        desc.tolerance = 0.01f;
        return of(rsh_frame, desc);
    }
    Call reduce() const { return of(rsh_reduce, valid.reduce()); }

    const ValidCalls valid{};
    const test::Buffer<uint8_t> bounds{1u << 20};

private:
    template <class Function, class Desc>
    static Call of(Function function, const Desc& desc) {
        return
            [=](cl_command_queue queue, cl_uint count, const cl_event* list, cl_event* done) {
                return function(device().rsh, queue, &desc, count, list, done);
            };
    }
};

cl::CommandQueue new_queue() {
    return {device().context, device().device};
}

class FailedEvent : public ::testing::Test {
protected:
    // Sets the gate to failed, a while after the test began to wait.
    std::thread failing_later() {
        return std::thread([this] {
            std::this_thread::sleep_for(kLater);
            gate.setStatus(CL_OUT_OF_RESOURCES);
        });
    }

    const WaitingCalls calls{};
    cl::UserEvent gate{device().context};
};

TEST_F(FailedEvent, InTheWaitListIsRefusedByEveryCall) {
    gate.setStatus(CL_OUT_OF_RESOURCES);
    cl::UserEvent complete(device().context);
    complete.setStatus(CL_COMPLETE);
    const cl_event list[] = {complete(), gate()};
    for (const WaitingCalls::Named& named : calls.all())
        for (const cl::CommandQueue& queue : {new_queue(), device().out_of_order_queue()}) {
            cl_event done = gate();
            const Outcome outcome =
                watched([&] { return named.call(queue(), 2, list, &done); });
            EXPECT_EQ(outcome.status, CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST)
                << named.name;
            EXPECT_EQ(done, nullptr) << named.name;
            for (const char* part : {"wait_list[1]", "CL_OUT_OF_RESOURCES"})
                EXPECT_NE(outcome.message.find(part), std::string::npos)
                    << named.name << ": " << outcome.message;
            EXPECT_LT(outcome.took_ms, kSoon.count()) << named.name;
            queue.finish();
        }
    EXPECT_TRUE(calls.valid.outputs_untouched());
}

// Any negative number is a failure, also one that OpenCL has no name for.
TEST_F(FailedEvent, MayHaveAnyNegativeStatus) {
    for (const cl_int status : {-1, -14, -4711}) {
        cl::UserEvent failed(device().context);
        failed.setStatus(status);
        const Outcome outcome =
            watched([&] { return calls.reduce()(new_queue()(), 1, &failed(), nullptr); });
        EXPECT_EQ(outcome.status, CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST);
        EXPECT_NE(outcome.message.find(std::to_string(status)), std::string::npos)
            << outcome.message;
    }
}

TEST_F(FailedEvent, EndsAFrameThatWaitsForIt) {
    for (const cl::CommandQueue& queue : {new_queue(), device().out_of_order_queue()}) {
        const WaitingCalls own{};
        gate = cl::UserEvent(device().context);
        std::thread failing = failing_later();
        cl_event done = nullptr;
        const Outcome outcome =
            watched([&] { return own.frame()(queue(), 1, &gate(), &done); });
        failing.join();
        EXPECT_EQ(outcome.status, CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST)
            << outcome.message;
        EXPECT_GE(outcome.took_ms, kLater.count()) << "it did not wait";
        EXPECT_LT(outcome.took_ms, (kLater + kSoon).count());
        EXPECT_EQ(done, nullptr);
        EXPECT_TRUE(own.valid.colour.untouched());
        RSH_CHECK(own.frame()(queue(), 0, nullptr, nullptr));  // and the next one renders
        queue.finish();
        EXPECT_FALSE(own.valid.colour.untouched());
    }
}

// The frame's own wait list holds a command of OpenCL's that waits in its turn.
TEST_F(FailedEvent, EndsAFrameThatWaitsForWhatWaitsForIt) {
    const cl::CommandQueue first = new_queue(), second = new_queue();
    const cl::Buffer words(device().context, CL_MEM_READ_WRITE, 64);
    const std::vector<cl::Event> waits = {gate};
    cl::Event filled;
    first.enqueueFillBuffer(words, cl_uint{0}, 0, 64, &waits, &filled);
    first.flush();
    std::thread failing = failing_later();
    const Outcome outcome =
        watched([&] { return calls.frame()(second(), 1, &filled(), nullptr); });
    failing.join();
    EXPECT_EQ(outcome.status, CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST) << outcome.message;
    EXPECT_LT(outcome.took_ms, (kLater + kSoon).count());
}

// It is too late to refuse: the calls are enqueued, and their own events fail.
TEST_F(FailedEvent, FailsTheDoneEventOfACallThatIsEnqueued) {
    for (const WaitingCalls::Named& named : calls.all()) {
        const std::string name = named.name;
        if (name.rfind("rsh_frame with bounces", 0) == 0 || name == "rsh_trace of batches")
            continue;  // they wait
        const cl::CommandQueue queue = new_queue();
        cl::UserEvent late(device().context);
        cl_event raw = nullptr;
        RSH_CHECK(named.call(queue(), 1, &late(), &raw));
        const cl::Event done(raw);
        queue.flush();
        late.setStatus(CL_OUT_OF_RESOURCES);
        watched([&] { return clWaitForEvents(1, &done()); });
        EXPECT_LT(done.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>(), 0) << named.name;
    }
    EXPECT_TRUE(calls.valid.outputs_untouched());
}

TEST_F(FailedEvent, EndsTheWaitForStatistics) {
    const test::OwnContext context;
    const cl::CommandQueue queue = new_queue();
    const rsh_reduce_desc desc = calls.valid.reduce();
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    RSH_CHECK(rsh_reduce(context.get(), queue(), &desc, 1, &gate(), nullptr));
    queue.flush();
    std::thread failing = failing_later();
    rsh_statistics sums = {};
    sums.struct_size = sizeof sums;
    const Outcome outcome = watched([&] { return rsh_get_statistics(context.get(), &sums); });
    failing.join();
    EXPECT_EQ(outcome.status, RSH_SUCCESS) << outcome.message;
    EXPECT_GT(sums.launches, 0u);
    EXPECT_LT(outcome.took_ms, (kLater + kSoon).count());
}

TEST_F(FailedEvent, IsToldByTheDeviceStatus) {
    const cl::CommandQueue queue = new_queue();
    RSH_CHECK(calls.reduce()(queue(), 1, &gate(), nullptr));
    queue.flush();
    std::thread failing = failing_later();
    const Outcome outcome = watched([&] { return rsh_device_status(device().rsh, queue()); });
    failing.join();
    EXPECT_EQ(outcome.status, CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST) << outcome.message;
    EXPECT_LT(outcome.took_ms, (kLater + kSoon).count());
    EXPECT_EQ(rsh_device_status(device().rsh, queue()), RSH_SUCCESS) << rsh_last_error();
}

TEST_F(FailedEvent, OfACallBeforeIsNoStrategysFault) {
    const test::OwnContext context;
    const cl::CommandQueue queue = new_queue();
    rsh_selftest report = {};
    report.struct_size = sizeof report;
    RSH_CHECK(rsh_device_selftest(context.get(), queue(), &report));  // compiles
    RSH_CHECK(calls.reduce()(queue(), 1, &gate(), nullptr));
    queue.flush();
    std::thread failing = failing_later();
    const Outcome outcome =
        watched([&] { return rsh_device_selftest(context.get(), queue(), &report); });
    failing.join();
    EXPECT_EQ(outcome.status, RSH_SUCCESS) << outcome.message;
    EXPECT_EQ(report.unsafe_strategies, 0u) << report.first_failure;
}

// PoCL is still busy with the failure when those wake up who wait for it.
TEST_F(FailedEvent, IsSurvivedByThoseWhoWaitForIt) {
    test::Random random(13);
    const test::OwnContext context;
    rsh_statistics sums = {};
    sums.struct_size = sizeof sums;
    for (int run = 0; run < 300; ++run) {
        const cl::CommandQueue queue = new_queue();
        cl::UserEvent late(device().context);
        const rsh_rasterize_desc desc = calls.valid.rasterize();
        RSH_CHECK(rsh_count_statistics(context.get(), run % 2));
        RSH_CHECK(rsh_rasterize(context.get(), queue(), &desc, 1, &late(), nullptr));
        queue.flush();
        const auto delay = std::chrono::microseconds(random.below(100));
        std::thread failing([&] {
            std::this_thread::sleep_for(delay);
            late.setStatus(CL_OUT_OF_RESOURCES);
        });
        RSH_CHECK(rsh_get_statistics(context.get(), &sums));
        rsh_device_status(context.get(), queue());
        RSH_CHECK(rsh_count_statistics(context.get(), CL_FALSE));
        failing.join();
    }
    EXPECT_TRUE(calls.valid.outputs_untouched());
}

// At any moment around the call: whichever comes first, nothing hangs and no failure is missed.
TEST_F(FailedEvent, IsNeverMissedByAFrame) {
    test::Random random(12);
    const cl::CommandQueue queue = new_queue();
    for (int run = 0; run < 200; ++run) {
        cl::UserEvent late(device().context);
        const auto delay = std::chrono::microseconds(random.below(200));
        std::thread failing([&] {
            std::this_thread::sleep_for(delay);
            late.setStatus(CL_OUT_OF_RESOURCES);
        });
        const Outcome outcome =
            watched([&] { return calls.frame()(queue(), 1, &late(), nullptr); });
        failing.join();
        ASSERT_EQ(outcome.status, CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST)
            << "after " << delay.count() << " us: " << outcome.message;
    }
    EXPECT_TRUE(calls.valid.colour.untouched());
}

}  // namespace
