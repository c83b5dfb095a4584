// amount.hpp - how much of every family is run: in a minute, by default, for a proof.
#pragma once

#include <vector>

#include "stability/family.hpp"

namespace bench::stability {

constexpr uint32_t kWays = 4;  // grid or list; closest and count, or any and all

struct Amount {
    uint32_t side;                    // of the squares of rays
    std::vector<uint32_t> triangles;  // about; rounds take them in turn
    uint32_t rounds;                  // scenes, each from random numbers of its own
    size_t judged_rays;               // by the oracle, per round
    bool is_in_turn;  // a round goes one of the ways and the next one the next, else all

    bool goes(uint32_t round, uint32_t way) const {
        return !is_in_turn || round % kWays == way;
    }
    Extent extent(uint32_t round) const {
        const uint32_t turn = is_in_turn ? round / kWays : round;
        return {side, triangles[turn % triangles.size()]};
    }
};

// Quick: every family within a minute on two cores. Full: 1e8 rays, 1e10 pairs and 1e8 decisions
// in all; a hundredth of it is what is tested with every change.
inline const Amount kQuick = {32, {300}, 1, 1024, false};
inline const Amount kUsual = {64, {600}, 4, 1024, false};
inline const Amount kHundredth = {78, {128}, 4, 512, true};
inline const Amount kFull = {256, {64, 256, 512}, 48, 8192, true};

}  // namespace bench::stability
