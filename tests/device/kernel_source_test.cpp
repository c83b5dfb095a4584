// kernel_source_test.cpp - a header that is included under a condition would be missing from
// whatever includes it after that: refused, with its place.
#include <gtest/gtest.h>

#include "api/valid_calls.hpp"
#include "support/changed_kernels.hpp"

namespace {

rsh_status reduce(rsh_context context) {
    const test::ValidCalls valid;
    rsh_reduce_desc desc = valid.reduce();
    desc.strategy = RSH_STRATEGY_ATOMIC;
    return rsh_reduce(context, test::device().queue(), &desc, 0, nullptr, nullptr);
}

void expect_refused(const char* file, const char* include) {
    const std::string line = std::string("#include \"") + include + '"';
    const test::ChangedKernels changed(file, line, "#if 0\n" + line + "\n#endif");
    EXPECT_EQ(reduce(changed.context()), RSH_INVALID_VALUE);
    const std::string message = rsh_last_error();
    EXPECT_NE(message.find(file), std::string::npos) << message;
    EXPECT_NE(message.find("under a condition"), std::string::npos) << message;
}

TEST(KernelSource, RefusesIncludesUnderAConditionInAProgram) {
    expect_refused("reduce/atomic.cl", "lanes/stride.h");
}

TEST(KernelSource, RefusesIncludesUnderAConditionInAHeader) {
    expect_refused("lanes/stride.h", "lanes/lanes.h");
}

}  // namespace
