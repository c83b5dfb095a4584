// departures.hpp - what becomes of rays that leave a closed convex body, and of those that go on
// inside: judged in double precision, or better, by the stored floats. Needs no device.
#pragma once

#include <string>
#include <vector>

#include "oracle/closest.hpp"
#include "support/mesh.hpp"

namespace test {

struct Fault {
    size_t count = 0;
    std::string first;
};

struct Tally {
    size_t outwards = 0, inwards = 0;  // rays
    Fault stopped;                     // of those outwards: by what is not there
    Fault misplaced;                   // of those inwards: out elsewhere than exactly
    size_t lost = 0;                   // of those inwards: hit nothing
    size_t again = 0;                  // of those inwards: enter once more, at their origin

    void add(const Tally& other);
};

// A body.
struct Journey {
    const Mesh& mesh;
    Double3 centre;  // any point inside
};

struct Departures {
    std::vector<rsh_ray> rays;
    std::vector<uint32_t> skip;         // the triangles that they left
    std::vector<rsh_hit> hits;          // that were reported
    std::vector<oracle::Answer> exact;  // of oracle::closest
};

Tally judge(const Journey& journey, const Departures& departures);

}  // namespace test
