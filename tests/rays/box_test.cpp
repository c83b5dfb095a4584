// box_test.cpp - the shape `box`: every block contains its active rays, every box of the scene
// its triangles or the boxes of its node.
#include <gtest/gtest.h>

#include "bvh/box_checks.hpp"
#include "support/cases.hpp"

namespace {

using test::Rays;

class Box : public ::testing::TestWithParam<test::NamedCase> {};

TEST_P(Box, ContainsEveryActiveRay) {
    test::Random random(3);
    const Rays rays = GetParam().make(random).rays;
    for (const bool converging : {false, true}) {
        SCOPED_TRACE(converging ? "converging" : "from the origins");
        expect_contains_all(rays, converging);
    }
}

TEST_P(Box, OfTheSceneContainsWhatIsBelowIt) {
    test::Random random(5);
    const test::Mesh mesh = GetParam().make(random).mesh;
    expect_contained(mesh, test::build_bvh(test::DeviceMesh(mesh)));
}

// The same triangles, so that their order serves.
TEST_P(Box, OfTheSceneContainsWhatIsBelowItAfterAnUpdate) {
    test::Random random(5);
    const test::Mesh mesh = GetParam().make(random).mesh;
    const test::DeviceMesh scene(mesh);
    expect_contained(mesh, test::refitted_bvhs({&scene, &scene})[1]);
}

INSTANTIATE_TEST_SUITE_P(All, Box, ::testing::ValuesIn(test::all_cases()), test::case_name);

TEST(BoxSizes, ContainRaysInGridsOfAnyShape) {
    test::Random random(4);
    const uint32_t shapes[][2] = {{1, 1}, {2, 1}, {1, 131}, {257, 1}, {17, 3}, {64, 65}};
    for (const auto& shape : shapes) {
        SCOPED_TRACE(std::to_string(shape[0]) + " x " + std::to_string(shape[1]));
        expect_contains_all(test::random_rays(random, shape[0], shape[1]), false);
    }
    expect_contains_all(test::converging_rays(random, 61, 47, {0.2f, 0.9f, 0.1f}), true);
}

}  // namespace
