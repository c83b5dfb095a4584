// box_checks.hpp - what must hold for every hierarchy and every scene of the bound `box`.
#pragma once

#include "support/trace.hpp"

// 0, 1, 2, ... in any order.
void expect_permutation(std::vector<uint32_t> numbers);

// Every block holds its active rays, with the room that rays/box_node.h asks for around their origins.
void expect_contains_all(const test::Rays& rays, bool converging);

struct BoxCounts {
    size_t clusters = 0, groups = 0;
};

// Each box holds the cluster or the group with its number, and each cluster its triangles. Leaves
// how many there are in `counts`, unless it is NULL.
void expect_contained(const test::Mesh& mesh, const test::SceneBoxes& boxes,
                      BoxCounts* counts = nullptr);
