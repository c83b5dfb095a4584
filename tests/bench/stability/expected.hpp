// expected.hpp - what the oracle says of the rays of a scene, once for all engines.
#pragma once

#include <optional>

#include "oracle/closest.hpp"
#include "oracle/crossings/crossings.hpp"
#include "stability/family.hpp"

namespace bench::stability {

struct Expected {
    std::vector<size_t> rays;  // ascending
    std::vector<oracle::Answer> answers;
    std::vector<oracle::Crossings> crossings;
    bool is_exact;  // no other is right
    oracle::Denormals denormals;
    uint64_t decisions = 0;  // active rays, times triangles
    uint64_t undecided = 0;  // of these, for closest and any
    uint64_t undecided_crossings = 0;
    std::optional<bool> is_inside = {};  // of a closed mesh, where all rays begin
    std::vector<uint32_t>
        twins;  // per triangle, the lowest with the same corners, in any order
};

// Of `most` rays at least, evenly among all, or of all.
Expected expected_answers(const Scene& scene, Kind kind, size_t most,
                          oracle::Denormals denormals = oracle::Denormals::kMayBeFlushed);

}  // namespace bench::stability
