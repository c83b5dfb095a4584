// accepts.hpp - the judgement of many answers as assertions of GoogleTest.
#pragma once

#include <gtest/gtest.h>

#include "oracle/closest.hpp"
#include "oracle/crossings/crossings.hpp"

namespace oracle {

// Every hit is one that a correct float routine may report.
::testing::AssertionResult hits_are_correct(const std::vector<Answer>& answers,
                                            const test::Mesh& mesh,
                                            const std::vector<rsh_ray>& rays,
                                            const std::vector<rsh_hit>& hits);

// Bit `bit` of every mask is set when a hit is certain and clear when none is possible.
::testing::AssertionResult occlusion_is_correct(const std::vector<Answer>& answers,
                                                const std::vector<rsh_ray>& rays,
                                                const std::vector<uint32_t>& masks,
                                                uint32_t bit);

// Those of ray i are hits[offsets[i]] up to hits[offsets[i + 1]].
::testing::AssertionResult all_hits_are_correct(const std::vector<Crossings>& expected,
                                                const std::vector<rsh_ray>& rays,
                                                const std::vector<uint64_t>& offsets,
                                                const std::vector<rsh_hit>& hits);

::testing::AssertionResult counts_are_correct(const std::vector<Crossings>& expected,
                                              const std::vector<rsh_ray>& rays,
                                              const std::vector<uint32_t>& counts);

}  // namespace oracle
