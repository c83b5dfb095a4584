// vertex_ranges_test.cpp - marked vertices as ranges.
#include <gtest/gtest.h>

#include "model/model.hpp"

namespace render {
namespace {

std::vector<std::pair<size_t, size_t>> ranges(std::initializer_list<size_t> marked) {
    std::vector<bool> marks(2000);
    for (const size_t i : marked) marks[i] = true;
    std::vector<std::pair<size_t, size_t>> pairs;
    for (const VertexRange& range : ranges_of(marks))
        pairs.push_back({range.first, range.count});
    return pairs;
}

using Pairs = std::vector<std::pair<size_t, size_t>>;

TEST(VertexRanges, HoldTheMarkedVerticesAndShortGaps) {
    EXPECT_EQ(ranges({}), Pairs{});
    EXPECT_EQ(ranges({0, 1, 2}), (Pairs{{0, 3}}));
    EXPECT_EQ(ranges({5, 262}), (Pairs{{5, 258}})) << "a gap of 256";
    EXPECT_EQ(ranges({5, 263}), (Pairs{{5, 1}, {263, 1}})) << "a gap of 257";
    EXPECT_EQ(ranges({1999}), (Pairs{{1999, 1}}));
}

}  // namespace
}  // namespace render
