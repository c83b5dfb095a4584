// faults_test.cpp - host memory runs out, or OpenCL fails, at any moment of any call, once or for
// good: the call says so, loses nothing, and the next one works. RSH_FAULT_SAMPLES is how many
// moments of each call are tried, 60 unless it says otherwise; where a call has no more, all are.
// RSH_FAULT_CALL is a part of the names of those to try.
#include "faults/faults.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "faults/every_call.hpp"
#include "support/compare.hpp"
#include "support/random.hpp"

namespace {

using faults::Armed;
using faults::Kind;
using faults::Plan;
using test::Call;

size_t samples() {
    const char* const value = std::getenv("RSH_FAULT_SAMPLES");
    return value ? std::strtoul(value, nullptr, 10) : 60;
}

// Ends the program when a call takes longer than any does.
class Watch {
public:
    explicit Watch(const std::string& what) : what_(what), thread_([this] { watch(); }) {}
    ~Watch() {
        ends_ = true;
        thread_.join();
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    void next() { ++beat_; }

private:
    void watch() {
        unsigned seen = 0, idle = 0;
        while (!ends_) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            const unsigned now = beat_;
            idle = now == seen ? idle + 1 : 0;
            seen = now;
            if (idle < 60 * 20) continue;
            std::fprintf(stderr, "%s hangs: moment %u\n", what_.c_str(), now);
            std::_Exit(1);
        }
    }

    std::string what_;
    std::atomic<unsigned> beat_{0};
    std::atomic<bool> ends_{false};
    std::thread thread_;
};

// The moments to try: all, or so many by chance.
std::vector<size_t> moments(size_t count, test::Random& random) {
    std::vector<size_t> chosen;
    if (count <= samples())
        for (size_t i = 0; i < count; ++i) chosen.push_back(i);
    else
        for (size_t i = 0; i < samples(); ++i)
            chosen.push_back(random.below(static_cast<uint32_t>(count)));
    return chosen;
}

constexpr cl_int kCodes[] = {CL_OUT_OF_HOST_MEMORY, CL_OUT_OF_RESOURCES,
                             CL_MEM_OBJECT_ALLOCATION_FAILURE, CL_INVALID_OPERATION};

struct Result {
    rsh_status status;
    std::string message;
};

Result run(const Call& call, const Plan& plan) {
    call.before();
    rsh_status status = RSH_SUCCESS;
    {
        const Armed armed(plan);
        status = call.run();
    }
    const Result result = {status, rsh_last_error()};
    call.after();
    return result;
}

size_t moments_of(const Call& call, Kind kind) {
    const Result result = run(call, {kind, ~size_t{0}});
    const size_t count = faults::counted();
    EXPECT_EQ(result.status, RSH_SUCCESS) << call.name << ": " << result.message;
    return count;
}

class Faults : public ::testing::Test {
protected:
    // Calls check(result, plan) for chosen moments of every call, each failing once and for good.
    template <class Check>
    void at_chosen_moments(Kind kind, Check check) {
        test::Random random(kind == Kind::memory ? 121 : 122);
        const auto before = calls_->traced();
        const char* const only = std::getenv("RSH_FAULT_CALL");
        for (const Call& call : calls_->all()) {
            if (only && !std::strstr(call.name, only)) continue;
            Watch watch(call.name);
            run(call, {});  // builds its programs
            const size_t count = moments_of(call, kind);
            for (const bool and_all_after : {false, true})
                for (const size_t moment : moments(count, random)) {
                    watch.next();
                    const Plan plan = {kind, moment, and_all_after,
                                       kCodes[random.below(std::size(kCodes))]};
                    const Result result = run(call, plan);
                    SCOPED_TRACE(std::string(call.name) + ", moment " + std::to_string(moment) +
                                 " of " + std::to_string(count) +
                                 (and_all_after ? " and all after " : " ") +
                                 faults::failed_call());
                    check(result, plan);
                    if (HasFailure()) return;
                }
            EXPECT_EQ(run(call, {}).status, RSH_SUCCESS)
                << call.name << " afterwards: " << rsh_last_error();
        }
        EXPECT_TRUE(test::same_bits(calls_->traced(), before, "hits"));
    }

    std::unique_ptr<test::EveryCall> calls_ = std::make_unique<test::EveryCall>();
};

TEST_F(Faults, OfHostMemoryAreTold) {
    at_chosen_moments(Kind::memory, [](const Result& result, const Plan&) {
        if (!faults::any_failed()) return;  // it was done without, or asked for less this time
        if (result.status == RSH_SUCCESS) return;
        EXPECT_EQ(result.status, RSH_OUT_OF_MEMORY) << result.message;
        EXPECT_EQ(result.message, "the host is out of memory");
    });
}

TEST_F(Faults, OfOpenClAreTold) {
    at_chosen_moments(Kind::opencl, [](const Result& result, const Plan& plan) {
        if (!faults::any_failed() || result.status == RSH_SUCCESS) return;
        const bool is_own = result.status == RSH_NO_DEVICE || result.status == RSH_BUILD_FAILED;
        EXPECT_TRUE(is_own || result.status == plan.code) << result.status << result.message;
        EXPECT_FALSE(result.message.empty());
    });
}

// Whatever failed, once the context is released all objects are.
TEST_F(Faults, OfOpenClLoseNoObject) {
    calls_.reset();
    test::device();
    const long before = faults::references();
    calls_ = std::make_unique<test::EveryCall>();
    at_chosen_moments(Kind::opencl, [](const Result&, const Plan&) {});
    calls_.reset();
    EXPECT_EQ(faults::references(), before);
}

}  // namespace
