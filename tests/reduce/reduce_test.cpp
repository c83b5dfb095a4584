// reduce_test.cpp - rsh_reduce against std::copy_if: every strategy, element size and kind of
// flag, awkward counts and patterns, counts that only the device knows.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <tuple>

#include "support/buffer.hpp"
#include "support/compare.hpp"
#include "support/strategies.hpp"

namespace {

using test::Buffer;
using test::Random;

enum class Pattern { none, all, alternate, runs, sparse, half, last };

bool kept(Pattern pattern, uint32_t i, uint32_t count, Random& random) {
    switch (pattern) {
        case Pattern::none:
            return false;
        case Pattern::all:
            return true;
        case Pattern::alternate:
            return i % 2 == 1;
        case Pattern::runs:
            return i / 100 % 2 == 0;
        case Pattern::sparse:
            return random.chance(0.01f);
        case Pattern::half:
            return random.chance(0.5f);
        case Pattern::last:
            return i + 1 == count;
    }
    return false;
}

struct Stream {
    cl_uint element_bytes;
    std::vector<uint32_t> words;  // element_bytes / 4 per element
    std::vector<uint8_t> flags;

    uint32_t count() const { return uint32_t(flags.size()); }
    // As RSH_KEEP_BITS wants them.
    std::vector<uint8_t> bits() const {
        std::vector<uint8_t> packed((flags.size() + 7) / 8);
        for (size_t i = 0; i < flags.size(); ++i)
            if (flags[i]) packed[i / 8] = uint8_t(packed[i / 8] | 1 << i % 8);
        return packed;
    }
};

// Any byte but 0 keeps. Elements that are dropped by value begin with RSH_NO_HIT; with flags,
// some elements look like that and must be kept all the same.
Stream make_stream(cl_uint keep, cl_uint element_bytes, uint32_t count, Pattern pattern) {
    Random random(count * 31 + element_bytes);
    Stream stream = {element_bytes, {}, {}};
    for (uint32_t i = 0; i < count; ++i) {
        const bool keeps = kept(pattern, i, count, random);
        stream.flags.push_back(keeps ? uint8_t(1 + random.below(255)) : uint8_t(0));
        for (uint32_t w = 0; w < element_bytes / 4; ++w)
            stream.words.push_back(random.chance(0.1f) && w > 0 ? RSH_NO_HIT : i * 4 + w);
        uint32_t& first = stream.words[size_t(i) * element_bytes / 4];
        if (keep == RSH_KEEP_NOT_NULL) first = keeps ? first : RSH_NO_HIT;
        if (keep != RSH_KEEP_NOT_NULL && random.chance(0.1f)) first = RSH_NO_HIT;
    }
    return stream;
}

// The definition, element by element.
std::vector<uint32_t> reference(const Stream& stream, uint32_t count) {
    const size_t words = stream.element_bytes / 4;
    std::vector<uint32_t> order(count), packed;
    std::iota(order.begin(), order.end(), 0u);
    std::vector<uint32_t> survivors;
    std::copy_if(order.begin(), order.end(), std::back_inserter(survivors),
                 [&](uint32_t i) { return stream.flags[i] != 0; });
    for (const uint32_t i : survivors)
        packed.insert(packed.end(), stream.words.begin() + long(i * words),
                      stream.words.begin() + long((i + 1) * words));
    return packed;
}

// For strategies that promise no order: as a set, by the words of each element in turn.
std::vector<uint32_t> sorted_elements(const std::vector<uint32_t>& words, size_t per_element) {
    std::vector<std::vector<uint32_t>> elements;
    for (size_t i = 0; i < words.size(); i += per_element)
        elements.emplace_back(words.begin() + long(i), words.begin() + long(i + per_element));
    std::sort(elements.begin(), elements.end());
    std::vector<uint32_t> sorted;
    for (const auto& element : elements)
        sorted.insert(sorted.end(), element.begin(), element.end());
    return sorted;
}

struct Options {
    cl_uint strategy = RSH_STRATEGY_DEFAULT;
    cl_uint keep = RSH_KEEP_FLAGS;
    uint32_t on_device = 0xffffffffu;  // the count on the device; all ones: none
    bool own_scratch = false;
    rsh_context context = nullptr;  // null: the device's
    int repeats = 1;
};

::testing::AssertionResult same_elements(const std::vector<uint32_t>& actual,
                                         const std::vector<uint32_t>& expected,
                                         cl_uint strategy, size_t per_element) {
    if (strategy == RSH_STRATEGY_DEFAULT || rsh_strategy_is_stable(strategy))
        return test::same_bits(actual, expected, "words");
    return test::same_bits(sorted_elements(actual, per_element),
                           sorted_elements(expected, per_element), "words");
}

void expect_reduced(const Stream& stream, const Options& options) {
    const uint32_t count = std::min(stream.count(), options.on_device);
    const std::vector<uint32_t> expected = reference(stream, count);
    const Buffer<uint32_t> input(stream.words);
    const Buffer<uint8_t> flags(options.keep == RSH_KEEP_BITS ? stream.bits() : stream.flags);
    // The room that the survivors need and no more, but for one element when there is none:
    // anything behind them lands in the guard or in that element.
    const size_t one = stream.element_bytes / 4;
    const Buffer<uint32_t> output(std::max(expected.size(), one)), output_count(1);
    const Buffer<uint32_t> input_count(std::vector<uint32_t>{options.on_device});

    rsh_reduce_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.strategy = options.strategy;
    desc.keep = options.keep;
    desc.element_bytes = stream.element_bytes;
    desc.count = stream.count();
    desc.input_count = options.on_device == 0xffffffffu ? nullptr : input_count.get();
    desc.input = input.get();
    desc.flags = options.keep == RSH_KEEP_NOT_NULL ? nullptr : flags.get();
    desc.output = output.get();
    desc.output_count = output_count.get();
    const rsh_context context = options.context ? options.context : test::device().rsh;
    std::unique_ptr<test::Bytes> scratch;
    if (options.own_scratch) {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_reduce_query(context, &desc, &sizes));
        if (sizes.scratch_bytes > 0)
            scratch = std::make_unique<test::Bytes>(sizes.scratch_bytes);
        desc.scratch = scratch ? scratch->get() : nullptr;
    }
    for (int repeat = 0; repeat < options.repeats && !::testing::Test::HasFailure(); ++repeat) {
        RSH_CHECK(rsh_reduce(context, test::device().queue(), &desc, 0, nullptr, nullptr));
        EXPECT_EQ(output_count.read()[0], expected.size() * 4 / stream.element_bytes);
        if (expected.empty()) {
            EXPECT_TRUE(output.untouched());
        } else {
            EXPECT_TRUE(same_elements(output.read(), expected, options.strategy, one))
                << "repeat " << repeat;
        }
    }
    EXPECT_TRUE(output.guards_intact());
    EXPECT_TRUE(output_count.guards_intact());
    EXPECT_TRUE(test::same_bits(input.read(), stream.words, "input words"));
    if (scratch) {
        EXPECT_TRUE(scratch->guards_intact());
    }
}

using Param = std::tuple<cl_uint, cl_uint, cl_uint>;  // strategy, keep, element bytes

class Reduce : public ::testing::TestWithParam<Param> {
protected:
    Options options() const { return {std::get<0>(GetParam()), std::get<1>(GetParam())}; }
    Stream stream(uint32_t count, Pattern pattern) const {
        return make_stream(std::get<1>(GetParam()), std::get<2>(GetParam()), count, pattern);
    }
};

std::vector<uint32_t> counts() {
    if (test::small()) return {0, 1, 63, 64, 65, 257};
    return {0, 1, 2, 63, 64, 65, 255, 256, 257, 1023, 1024, 1025, 4099, 65537};
}

constexpr Pattern kPatterns[] = {Pattern::none, Pattern::all,    Pattern::alternate,
                                 Pattern::runs, Pattern::sparse, Pattern::half,
                                 Pattern::last};

TEST_P(Reduce, EqualsCopyIfForEveryCountAndPattern) {
    for (const uint32_t count : counts())
        for (const Pattern pattern : kPatterns) {
            SCOPED_TRACE("count " + std::to_string(count) + ", pattern " +
                         std::to_string(int(pattern)));
            expect_reduced(stream(count, pattern), options());
            if (HasFailure()) return;
        }
}

TEST_P(Reduce, EqualsCopyIfForAMillionElements) {
    if (test::small()) GTEST_SKIP() << "RSH_TEST_SMALL is set: too many for an emulator";
    for (const Pattern pattern : {Pattern::half, Pattern::all, Pattern::sparse})
        expect_reduced(stream(1u << 20, pattern), options());
}

TEST_P(Reduce, TakesItsCountFromTheDevice) {
    for (const uint32_t on_device : {0u, 1u, 63u, 64u, 65u, 500u, 999u, 1000u, 5000u}) {
        SCOPED_TRACE("count on the device " + std::to_string(on_device));
        Options with_count = options();
        with_count.on_device = on_device;
        expect_reduced(stream(1000, Pattern::half), with_count);
    }
}

TEST_P(Reduce, StaysInsideTheScratchThatTheQueryAsksFor) {
    for (const uint32_t count : counts()) {
        SCOPED_TRACE("count " + std::to_string(count));
        Options own = options();
        own.own_scratch = true;
        expect_reduced(stream(count, Pattern::half), own);
    }
}

TEST_P(Reduce, GivesTheSameAHundredTimes) {
    if (test::small()) GTEST_SKIP() << "RSH_TEST_SMALL is set: too many for an emulator";
    Options repeated = options();
    repeated.repeats = 100;
    expect_reduced(stream(20011, Pattern::half), repeated);
}

std::vector<cl_uint> default_and_all() {
    std::vector<cl_uint> all = test::all_strategies();
    all.insert(all.begin(), RSH_STRATEGY_DEFAULT);
    return all;
}

std::string name_of(const ::testing::TestParamInfo<Param>& info) {
    const char* const keeps[] = {"_flags_", "_not_null_", "_bits_"};
    return test::strategy_name(std::get<0>(info.param)) + keeps[std::get<1>(info.param)] +
           std::to_string(std::get<2>(info.param));
}

INSTANTIATE_TEST_SUITE_P(All, Reduce,
                         ::testing::Combine(::testing::ValuesIn(default_and_all()),
                                            ::testing::Values(RSH_KEEP_FLAGS, RSH_KEEP_NOT_NULL,
                                                              RSH_KEEP_BITS),
                                            ::testing::Values(4u, 8u, 12u, 16u)),
                         name_of);

// The others' answers would have to be sorted.
std::vector<cl_uint> stable_strategies() {
    std::vector<cl_uint> stable;
    for (const cl_uint strategy : test::all_strategies())
        if (rsh_strategy_is_stable(strategy)) stable.push_back(strategy);
    return test::not_empty(stable, "stable strategies");
}

class ReduceLarge : public ::testing::TestWithParam<cl_uint> {};  // element bytes

// Streams of 32 MB and more may be stored past the caches, line by line; see
// kernels/reduce/range_compress.h.
TEST_P(ReduceLarge, EqualsCopyIf) {
    if (test::small()) GTEST_SKIP() << "RSH_TEST_SMALL is set: too many for an emulator";
    const uint32_t count = (32u << 20) / GetParam() + 13;
    for (const Pattern pattern : {Pattern::half, Pattern::all, Pattern::sparse}) {
        const Stream stream = make_stream(RSH_KEEP_NOT_NULL, GetParam(), count, pattern);
        for (const cl_uint strategy : stable_strategies()) {
            SCOPED_TRACE(test::strategy_name(strategy));
            Options options;
            options.strategy = strategy;
            options.keep = RSH_KEEP_NOT_NULL;
            expect_reduced(stream, options);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, ReduceLarge, ::testing::Values(4u, 8u, 12u, 16u),
                         ::testing::PrintToStringParamName());

using WidthParam = std::tuple<cl_uint, cl_uint>;  // strategy, vector width

class ReduceWidth : public ::testing::TestWithParam<WidthParam> {};

// Width 1 takes the kernels for work-groups, the others those for single work-items.
TEST_P(ReduceWidth, DoesNotChangeTheAnswer) {
    const test::OwnContext context(std::get<1>(GetParam()));
    Options options;
    options.strategy = std::get<0>(GetParam());
    options.context = context.get();
    for (const uint32_t count : counts()) {
        SCOPED_TRACE("count " + std::to_string(count));
        expect_reduced(make_stream(options.keep, 8, count, Pattern::half), options);
    }
    if (!test::small())
        expect_reduced(make_stream(options.keep, 8, 300007, Pattern::runs), options);
}

std::string width_name_of(const ::testing::TestParamInfo<WidthParam>& info) {
    return test::strategy_name(std::get<0>(info.param)) + "_" +
           std::to_string(std::get<1>(info.param));
}

INSTANTIATE_TEST_SUITE_P(All, ReduceWidth,
                         ::testing::Combine(::testing::ValuesIn(default_and_all()),
                                            ::testing::Values(1u, 4u, 8u, 16u)),
                         width_name_of);

}  // namespace
