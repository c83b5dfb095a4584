// leaving.hpp - sends rays into a scene of one mesh, and all that leaves where they hit.
#pragma once

#include "shade/departures.hpp"
#include "support/rays.hpp"
#include "support/render.hpp"

namespace test {

struct Sending {
    std::vector<uint32_t> kinds;    // RSH_SPAWN_...
    float index = 1.5f;             // of refraction; 0: a mirror
    rsh_context context = nullptr;  // that spawns and traces; null: the device's
};

// What leaves, and what it hits, for each kind; `exact` is empty.
std::vector<Departures> send(const Mesh& mesh, const Rays& rays, const Sending& sending);

// The same, judged.
Tally follow(const Mesh& mesh, Double3 centre, const Rays& rays, const Sending& sending);

}  // namespace test
