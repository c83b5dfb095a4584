// layout_test.cpp - how much room a BVH takes: needs no device.
#include <gtest/gtest.h>

#include "bvh/layout.hpp"

namespace {

size_t words(rsh_uint triangles) {
    rsh_geometry geometry = {};
    geometry.triangle_count = triangles;
    return rsh::bvh_words(rsh::bvh_layouts_of(geometry));
}

TEST(BvhLayout, OfFewerTrianglesFitsIntoTheMostUpTo) {
    size_t most = 0;
    for (rsh_uint triangles = 1; triangles < 160000; ++triangles) {
        most = std::max(most, words(triangles));
        ASSERT_EQ(rsh::most_bytes_up_to(triangles, words), most) << triangles << " triangles";
    }
    EXPECT_LT(words(4112), words(4111)) << "there is nothing to look for";
}

TEST(BvhLayout, GrowsWithTrianglesWherePartsAreFull) {
    for (rsh_uint triangles = 160000; triangles < 20000000; triangles += 8191)
        ASSERT_LE(words(triangles - 8191), words(triangles)) << triangles << " triangles";
}

}  // namespace
