// selftest_test.cpp - rsh_device_selftest finds what is wrong and masks it. What a driver may
// miscompile is played by kernels that are changed on their way to it.
#include <gtest/gtest.h>

#include "support/buffer.hpp"
#include "support/changed_kernels.hpp"
#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

rsh_selftest run_selftest(rsh_context context) {
    rsh_selftest report = {};
    report.struct_size = sizeof report;
    RSH_CHECK(rsh_device_selftest(context, test::device().queue(), &report));
    return report;
}

// Every second of 100003 elements.
class Reduction {
public:
    Reduction() {
        for (uint32_t i = 0; i < kCount; ++i)
            if (i % 2) expected_.push_back(i);
        std::vector<uint32_t> words(kCount);
        std::vector<uint8_t> flags(kCount);
        for (uint32_t i = 0; i < kCount; ++i) {
            words[i] = i;
            flags[i] = i % 2;
        }
        input_.write(words);
        flags_.write(flags);
        desc_.struct_size = sizeof desc_;
        desc_.element_bytes = 4;
        desc_.count = kCount;
        desc_.input = input_.get();
        desc_.flags = flags_.get();
        desc_.output = output_.get();
        desc_.output_count = output_count_.get();
    }

    rsh_status run(rsh_context context, cl_uint strategy) {
        desc_.strategy = strategy;
        return rsh_reduce(context, test::device().queue(), &desc_, 0, nullptr, nullptr);
    }
    rsh_status query(rsh_context context, cl_uint strategy) {
        desc_.strategy = strategy;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        return rsh_reduce_query(context, &desc_, &sizes);
    }
    ::testing::AssertionResult is_right() const {
        return test::same_bits(output_.read(), expected_, "words");
    }

private:
    static constexpr uint32_t kCount = 100003;
    std::vector<uint32_t> expected_;
    test::Buffer<uint32_t> input_{kCount}, output_{kCount / 2}, output_count_{1};
    test::Buffer<uint8_t> flags_{kCount};
    rsh_reduce_desc desc_ = {};
};

TEST(SelfTest, FindsEveryStrategySafeHere) {
    const test::OwnContext context;
    const rsh_selftest report = run_selftest(context.get());
    EXPECT_EQ(report.unsafe_strategies, 0u) << report.first_failure;
    EXPECT_STREQ(report.first_failure, "");
    for (cl_uint id = 1; rsh_strategy_name(id); ++id)
        EXPECT_EQ(report.tested_strategies >> id & 1, id == RSH_STRATEGY_AUTO ? 0u : 1u)
            << rsh_strategy_name(id);
}

TEST(SelfTest, MasksAndNamesAStrategyThatIsCompiledWrong) {
    const test::ChangedKernels wrong("reduce/scan_scatter.cl", "at += rank.total;",
                                     "at += rank.total - (tile.begin > 60000);");
    const rsh_selftest report = run_selftest(wrong.context());
    EXPECT_EQ(report.unsafe_strategies, 1u << RSH_STRATEGY_SCAN_SCATTER);
    const std::string failure = report.first_failure;
    EXPECT_EQ(failure.find("scan_scatter: "), 0u) << failure;
    EXPECT_NE(failure.find(" elements, kept: "), std::string::npos) << failure;

    Reduction reduction;
    EXPECT_EQ(reduction.run(wrong.context(), RSH_STRATEGY_SCAN_SCATTER), RSH_UNSUPPORTED);
    EXPECT_NE(std::string(rsh_last_error()).find("strategy: is scan_scatter"),
              std::string::npos);
    EXPECT_EQ(reduction.query(wrong.context(), RSH_STRATEGY_SCAN_SCATTER), RSH_UNSUPPORTED);
    EXPECT_EQ(reduction.run(wrong.context(), RSH_STRATEGY_CHUNK), RSH_SUCCESS);
    EXPECT_TRUE(reduction.is_right());
}

TEST(SelfTest, NamesAStrategyThatDoesNotCompile) {
    const test::ChangedKernels wrong("reduce/atomic.cl", "__kernel void", "__kernel vid");
    const rsh_selftest report = run_selftest(wrong.context());
    EXPECT_EQ(report.unsafe_strategies, 1u << RSH_STRATEGY_ATOMIC);
    EXPECT_EQ(std::string(report.first_failure).find("atomic: "), 0u) << report.first_failure;
}

TEST(SelfTest, KeepsAutoFromWhatItMasked) {
    const test::ChangedKernels wrong("reduce/lookback.cl", "return at;",
                                     "return at + (at > 0);");
    Reduction reduction;
    EXPECT_EQ(run_selftest(wrong.context()).unsafe_strategies, 1u << RSH_STRATEGY_LOOKBACK);
    EXPECT_EQ(reduction.run(wrong.context(), RSH_STRATEGY_AUTO), RSH_SUCCESS);
    EXPECT_TRUE(reduction.is_right());
}

// Whatever another thread finds out meanwhile: a call has memory for the strategy that it chose.
// This driver gets lookback wrong, but for the stream of a traversal.
TEST(SelfTest, LeavesCallsUnderWayWithTheirStrategy) {
    const test::ChangedKernels wrong("reduce/lookback.cl", "return at;",
                                     "return at + (RSH_WORDS == 1 && at > 0);");
    test::Random random(3);
    const test::DeviceMesh mesh(test::random_soup(random, 20000, 0.02f));
    const test::Rays rays = test::random_rays(random, 32, 32);
    test::TraceOptions options;
    options.engine = RSH_ENGINE_PAPER_FAITHFUL;
    options.context = wrong.context();
    options.budget = 2u << 20;
    int batches = 0;
    cl_uint unsafe = 0;
    options.before_batch = [&] {
        if (batches++ == 0) unsafe = run_selftest(wrong.context()).unsafe_strategies;
    };
    const auto hits = closest_hits(mesh, rays, options);
    EXPECT_GT(batches, 1);
    EXPECT_EQ(unsafe, 1u << RSH_STRATEGY_LOOKBACK);
    EXPECT_TRUE(test::same_bits(hits, closest_hits(mesh, rays, test::brute_force()), "hits"));
}

// As if no work-group ever saw another one's messages.
TEST(Lookback, NeedsNoAnswerFromOtherTiles) {
    const test::ChangedKernels silent("reduce/lookback.cl", "return atomic_add(word, 0);",
                                      "return 0;");
    Reduction reduction;
    EXPECT_EQ(reduction.run(silent.context(), RSH_STRATEGY_LOOKBACK), RSH_SUCCESS);
    EXPECT_TRUE(reduction.is_right());
}

}  // namespace
