// box_checks.hpp - what must hold for every hierarchy and every scene of the shape `box`.
#pragma once

#include "support/trace.hpp"

// 0, 1, 2, ... in any order.
void expect_permutation(std::vector<uint32_t> numbers);

// Every block holds its active rays, with the room that rays/box_node.h asks for around their
// origins.
void expect_contains_all(const test::Rays& rays, bool converging);

struct BvhCounts {
    size_t leaves = 0, nodes = 0;
};

// Each box holds the leaf or the node with its number, and each leaf its triangles. Leaves
// how many there are in `counts`, unless it is NULL.
void expect_contained(const test::Mesh& mesh, const test::SceneBvh& bvh,
                      BvhCounts* counts = nullptr);
