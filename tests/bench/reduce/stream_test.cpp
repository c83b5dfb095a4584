// stream_test.cpp - streams hold what their patterns promise, and wrong answers are noticed.
#include <gtest/gtest.h>

#include <algorithm>

#include "reduce/parts.hpp"
#include "reduce/patterns.hpp"

namespace {

using bench::Stream;
using bench::StreamSpec;

Stream stream(const std::string& pattern, int keep_percent, cl_uint bytes = 8) {
    const StreamSpec spec = {pattern, 100000, bytes, keep_percent};
    return bench::make_stream(spec, bench::make_flags(spec));
}

// The words of the kept elements, in order.
std::vector<cl_uint> kept(const Stream& s) {
    std::vector<cl_uint> words;
    const cl_uint per_element = s.words_per_element();
    for (size_t i = 0; i < s.count(); ++i)
        if (s.flags[i])
            words.insert(words.end(), s.words.begin() + long(i * per_element),
                         s.words.begin() + long((i + 1) * per_element));
    return words;
}

bool is_answer(const Stream& s, const std::vector<cl_uint>& words, bool is_stable) {
    return bench::is_answer(s, words.data(), words.size() / s.words_per_element(), is_stable);
}

class Patterns : public ::testing::TestWithParam<const char*> {};

TEST_P(Patterns, KeepTheShareThatIsAskedFor) {
    for (const int percent : {0, 1, 10, 50, 90, 99, 100}) {
        const double tolerance = GetParam() == std::string("runs") ? 5.0 : 1.0;
        EXPECT_NEAR(stream(GetParam(), percent).kept_percent(), percent, tolerance) << percent;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Patterns,
                         ::testing::Values("random", "runs", "alternating", "sorted"),
                         [](const auto& pattern) { return std::string(pattern.param); });

TEST(RunsPattern, IsClustered) {
    const Stream runs = stream("runs", 50), random = stream("random", 50);
    const auto changes = [](const Stream& s) {
        size_t count = 0;
        for (size_t i = 1; i < s.flags.size(); ++i) count += s.flags[i] != s.flags[i - 1];
        return count;
    };
    EXPECT_LT(changes(runs) * 20, changes(random));
}

TEST(Answer, MustBeWholeAndInOrderUnlessThatIsNotPromised) {
    const Stream s = stream("random", 50);
    EXPECT_TRUE(is_answer(s, kept(s), true));
    std::vector<cl_uint> turned = kept(s);
    std::rotate(turned.begin(), turned.begin() + 2, turned.end());
    EXPECT_FALSE(is_answer(s, turned, true));
    EXPECT_TRUE(is_answer(s, turned, false));
}

// Streams of several parts are made and checked by several threads.
TEST(Answer, IsCheckedToTheLastElementOfTheLastPart) {
    const StreamSpec spec = {"random", 2 * bench::kPartLength + 77, 4, 50};
    const Stream s = bench::make_stream(spec, bench::make_flags(spec));
    std::vector<cl_uint> right = kept(s);
    EXPECT_EQ(right.size(), s.kept_count);
    EXPECT_TRUE(is_answer(s, right, true));
    EXPECT_TRUE(is_answer(s, right, false));
    for (const size_t at : {size_t{0}, right.size() / 2, right.size() - 1}) {
        std::vector<cl_uint> broken = right;
        ++broken[at];
        EXPECT_FALSE(is_answer(s, broken, true)) << at;
    }
}

TEST(Answer, IsWrongWhenAnElementIsMissingDoubledOrBroken) {
    const Stream s = stream("random", 50);
    const std::vector<cl_uint> right = kept(s);
    std::vector<cl_uint> missing(right.begin(), right.end() - 2), doubled = right,
                                                                  broken = right;
    std::copy_n(doubled.begin(), 2, doubled.begin() + 2);
    broken[3] ^= 1;
    for (const bool is_stable : {true, false}) {
        EXPECT_FALSE(is_answer(s, missing, is_stable));
        EXPECT_FALSE(is_answer(s, doubled, is_stable));
        EXPECT_FALSE(is_answer(s, broken, is_stable));
    }
}

}  // namespace
