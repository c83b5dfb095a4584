// box_checks.hpp - what must hold for every hierarchy and every scene of the bound `box`.
#pragma once

#include "../support/trace.hpp"

// 0, 1, 2, ... in any order.
void expect_permutation(std::vector<uint32_t> numbers);

// Every block holds its active rays, with the room that box.h asks for around their origins.
void expect_contains_all(const test::Rays& rays, bool converging);

// Level by level: each box holds the cluster or the group with its number.
void expect_contained(const test::Mesh& mesh, const test::SceneBoxes& boxes);
