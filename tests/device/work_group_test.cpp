// work_group_test.cpp - what a kernel bears is asked for before it is launched.
#include <gtest/gtest.h>

#include "device/cl/work_group.hpp"
#include "device/error.hpp"
#include "support/buffer.hpp"
#include "support/changed_kernels.hpp"

namespace {

constexpr rsh::GroupLimits kLimits = {32, 100, 1000};

std::string refusal(const rsh::Range& range, const rsh::GroupLimits& limits) {
    try {
        rsh::fitting_group("some_kernel", range, limits);
    } catch (const rsh::Error& error) {
        EXPECT_EQ(error.status(), RSH_UNSUPPORTED);
        return error.what();
    }
    return "";
}

TEST(WorkGroup, HasTheSizeThatWasAskedFor) {
    EXPECT_EQ(rsh::fitting_group("some_kernel", {100, 32}, kLimits), 32u);
    EXPECT_EQ(rsh::fitting_group("some_kernel", {100, 8, true}, kLimits), 8u);
}

TEST(WorkGroup, IsSmallerWhereNothingDependsOnIt) {
    EXPECT_EQ(rsh::fitting_group("some_kernel", {100, 64, true}, kLimits), 32u);
}

TEST(WorkGroup, IsRefusedWhereItMustBeThatLarge) {
    EXPECT_EQ(
        refusal({100, 64}, kLimits),
        "some_kernel: needs work-groups of 64 work-items, the device runs at most 32 of this "
        "kernel");
}

TEST(WorkGroup, IsRefusedForWantOfLocalMemory) {
    EXPECT_EQ(refusal({100, 8, true}, {32, 1001, 1000}),
              "some_kernel: needs 1001 bytes of local memory, the device has 1000");
}

// 1 GB.
TEST(WorkGroup, OfAGreedyKernelIsRefused) {
    const test::ChangedKernels greedy("reduce/scan_counts.cl",
                                      "const uint me = get_local_id(0),",
                                      "__local uint hoard[1u << 28];\n"
                                      "hoard[get_local_id(0) * blocks] = blocks;\n"
                                      "barrier(CLK_LOCAL_MEM_FENCE);\n"
                                      "if (hoard[blocks] == 1) return;\n"
                                      "const uint me = get_local_id(0),");
    const test::Buffer<uint32_t> input(2000), output(2000), kept(1);
    rsh_reduce_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.strategy = RSH_STRATEGY_SCAN_SCATTER;
    desc.keep = RSH_KEEP_NOT_NULL;
    desc.element_bytes = 4;
    desc.count = 2000;
    desc.input = input.get();
    desc.output = output.get();
    desc.output_count = kept.get();
    EXPECT_EQ(rsh_reduce(greedy.context(), test::device().queue(), &desc, 0, nullptr, nullptr),
              RSH_UNSUPPORTED);
    EXPECT_NE(std::string(rsh_last_error()).find("bytes of local memory"), std::string::npos)
        << rsh_last_error();
    test::device().queue.finish();
}

}  // namespace
