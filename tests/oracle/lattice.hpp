// lattice.hpp - brute force in integers. Where corners, origins and directions are small integers
// nothing is rounded and nothing stays undecided: edges, corners and equal t included.
//
// If moreover every component of a direction is 0 or a power of two, and every triangle has a
// right angle and legs along two axes whose lengths are powers of two, then all that a float
// routine shears, multiplies and divides by is a power of two, too. Its numbers fit into 24 bits,
// so it must give this oracle's answer, in every bit of t.
#pragma once

#include "oracle/judge.hpp"

namespace oracle {

constexpr int kLatticeReach = 128;     // of corners and origins
constexpr int kLatticeDirection = 16;  // of components of a direction

// As closest(), and none is ambiguous. Edge-on triangles are not hit. Throws std::invalid_argument
// at what is no integer, or too large for 64 bits.
std::vector<Answer> lattice_closest(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                                    const std::vector<uint32_t>& skip = {});

// No other t and no other triangle is right.
Verdict judge_exact(const Answer& answer, const test::Mesh& mesh, const rsh_ray& ray,
                    const rsh_hit& hit);

}  // namespace oracle
