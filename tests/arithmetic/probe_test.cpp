// probe_test.cpp - rsh_device_selftest tells which arithmetic does not hold. Devices that get it
// wrong are played by kernels that are changed on their way to the driver.
#include <gtest/gtest.h>

#include <set>

#include "support/changed_kernels.hpp"

namespace {

constexpr cl_uint kProperties = RSH_ARITHMETIC_CONVERSION + 1;
const char* const kProbe = "arithmetic/probe.cl";

rsh_selftest run_selftest(rsh_context context) {
    rsh_selftest report = {};
    report.struct_size = sizeof report;
    RSH_CHECK(rsh_device_selftest(context, test::device().queue(), &report));
    return report;
}

// What flushes an expression of the kernel's to 0.
std::string flushed(const std::string& x) {
    return "select(" + x + ", (F)(0.0f), fabs(" + x + ") < (F)(FLT_MIN))";
}

TEST(Arithmetic, HoldsHere) {
    const test::OwnContext context;
    const rsh_selftest report = run_selftest(context.get());
    EXPECT_EQ(report.tested_arithmetic, (1u << kProperties) - 1);
    EXPECT_EQ(report.wrong_arithmetic, 0u) << report.arithmetic_failure;
    EXPECT_STREQ(report.arithmetic_failure, "");
    EXPECT_GT(report.arithmetic_cases, 100000u);
    const auto config = test::device().device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
    EXPECT_FALSE(report.flushes_denormals && (config & CL_FP_DENORM));
}

TEST(Arithmetic, HasANameForEachProperty) {
    std::set<std::string> names;
    for (cl_uint property = 0; property < kProperties; ++property) {
        ASSERT_NE(rsh_arithmetic_name(property), nullptr) << property;
        names.insert(rsh_arithmetic_name(property));
    }
    EXPECT_EQ(names.size(), kProperties);
    EXPECT_STREQ(rsh_arithmetic_name(RSH_ARITHMETIC_CONVERSION), "conversion");
    EXPECT_EQ(rsh_arithmetic_name(kProperties), nullptr);
}

struct Change {
    const char* name;
    cl_uint property;
    const char *from, *to;
};

class WrongArithmetic : public ::testing::TestWithParam<Change> {};

TEST_P(WrongArithmetic, IsFoundAndNamed) {
    const Change& change = GetParam();
    const test::ChangedKernels wrong(kProbe, change.from, change.to);
    const rsh_selftest report = run_selftest(wrong.context());
    const std::string failure = report.arithmetic_failure;
    EXPECT_TRUE(report.wrong_arithmetic >> change.property & 1) << report.wrong_arithmetic;
    EXPECT_EQ(report.wrong_arithmetic & ((1u << change.property) - 1), 0u);
    EXPECT_EQ(failure.find(rsh_arithmetic_name(change.property) + std::string(": ")), 0u)
        << failure;
    EXPECT_NE(failure.find(", must be "), std::string::npos) << failure;
    EXPECT_EQ(report.unsafe_strategies, 0u) << report.first_failure;
}

const Change kChanges[] = {
    {"LastBitCut", RSH_ARITHMETIC_ROUNDING, "as_##I(a - b)", "as_##I(a - b) & (I)(~1)"},
    {"SumRegrouped", RSH_ARITHMETIC_ROUNDING, "(sum - b_added)", "a"},
    {"ProductFused", RSH_ARITHMETIC_CONTRACTION, "a * b + c", "fma(a, b, c)"},
    {"OneOfTwoFused", RSH_ARITHMETIC_CONTRACTION, "a * b - c * d", "fma(a, b, -(c * d))"},
    {"FmaRoundedTwice", RSH_ARITHMETIC_FMA, "fma(a, b, c)", "(a * b + c)"},
    {"QuotientOff", RSH_ARITHMETIC_DIVISION, "a / b", "a / b * (F)(0x1.00001p0f)"},
    {"RootOff", RSH_ARITHMETIC_SQUARE_ROOT, "sqrt(a)", "sqrt(a) * (F)(0x1.00001p0f)"},
    {"NaNForgotten", RSH_ARITHMETIC_COMPARISON, "a <= b", "!(a > b)"},
    {"NaNKept", RSH_ARITHMETIC_COMPARISON, "fmax(a, b)", "select(a, b, a < b)"},
    {"InfinityIsFinite", RSH_ARITHMETIC_COMPARISON, "isfinite(a)", "(a == a)"},
    {"SumSaturates", RSH_ARITHMETIC_INFINITY, "sum = a + b", "sum = fmin(a + b, (F)(FLT_MAX))"},
    {"DenormalsRaised", RSH_ARITHMETIC_UNDERFLOW, "product = a * b",
     "product = select(a * b, (F)(FLT_MIN), (fabs(a * b) < (F)(FLT_MIN)) & (a * b != (F)(0)))"},
    {"IntRounded", RSH_ARITHMETIC_CONVERSION, "convert_##I(a)", "convert_##I(rint(a))"},
    {"FloorCuts", RSH_ARITHMETIC_CONVERSION, "floor(a)", "trunc(a)"},
};

INSTANTIATE_TEST_SUITE_P(Of, WrongArithmetic, ::testing::ValuesIn(kChanges),
                         [](const auto& change) { return std::string(change.param.name); });

TEST(Arithmetic, MayFlushResults) {
    const test::ChangedKernels flushes(kProbe, "product = a * b",
                                       "product = " + flushed("a * b"));
    const rsh_selftest report = run_selftest(flushes.context());
    EXPECT_EQ(report.wrong_arithmetic, 0u) << report.arithmetic_failure;
    EXPECT_TRUE(report.flushes_denormals);
}

TEST(Arithmetic, MayFlushOperands) {
    const test::ChangedKernels flushes(
        kProbe, "fma(a, b, c)",
        "fma(" + flushed("a") + ", " + flushed("b") + ", " + flushed("c") + ")");
    const rsh_selftest report = run_selftest(flushes.context());
    EXPECT_EQ(report.wrong_arithmetic, 0u) << report.arithmetic_failure;
    EXPECT_TRUE(report.flushes_denormals);
}

TEST(Arithmetic, IsNotBelievedWhereProbesDoNotCompile) {
    const test::ChangedKernels wrong(kProbe, "__kernel void", "__kernel vid");
    const rsh_selftest report = run_selftest(wrong.context());
    EXPECT_EQ(report.wrong_arithmetic, (1u << kProperties) - 1);
    EXPECT_NE(std::string(report.arithmetic_failure).find("arithmetic/probe.cl"),
              std::string::npos)
        << report.arithmetic_failure;
}

}  // namespace
