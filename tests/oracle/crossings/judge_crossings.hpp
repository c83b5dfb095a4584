// judge_crossings.hpp - what is wrong with the answers to count and all, by the oracle's.
#pragma once

#include "oracle/crossings/crossings.hpp"
#include "oracle/judge.hpp"

namespace oracle {

Verdict judge_count(const Crossings& expected, uint64_t count);

// `hits`: all of one ray, `count` of them.
Verdict judge_all(const Crossings& expected, const rsh_hit* hits, size_t count);

// From inside of a closed mesh to infinity, or right through it.
Verdict judge_parity(uint64_t count, bool is_inside);

// Pairs that a correct routine may report or not.
uint64_t count_undecided(const Crossings& expected);

}  // namespace oracle
