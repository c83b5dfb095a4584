// limits_test.cpp - the largest values that a descriptor may hold: queries refuse what calls
// refuse, and what they accept fits the counters of the kernels.
#include <gtest/gtest.h>

#include "valid_calls.hpp"

namespace {

using test::device;

// 2^36 bytes and more once made a limit whose four-fold wrapped in 32 bits: every hit was lost.
TEST(Limits, OfTheBudgetKeepACountOfCandidatesIn32Bits) {
    if (sizeof(size_t) < 8) GTEST_SKIP() << "no such budget with 32-bit sizes";
    const test::ValidCalls valid;
    rsh_traverse_desc desc = valid.traverse();
    desc.engine = RSH_ENGINE_PAPER;
    desc.geometry.triangle_count = (1u << 28) - 1;
    desc.width = desc.height = 16384;
    size_t bytes[3] = {};
    for (int i = 0; i < 3; ++i) {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        desc.budget = size_t{1} << (34 + i);
        RSH_CHECK(rsh_traverse_query(device().rsh, &desc, &sizes));
        bytes[i] = sizes.scratch_bytes;
    }
    EXPECT_LT(bytes[0], bytes[1]);
    EXPECT_EQ(bytes[1], bytes[2]);
}

}  // namespace
