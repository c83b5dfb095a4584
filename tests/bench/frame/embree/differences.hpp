// differences.hpp - where rsh and Embree answer differently, and why. Embree's default mode is
// not watertight and knows no rule for equal distances; rsh's is exact against brute force,
// which another check proves. Judges; fixes nothing.
#pragma once

#include <cstddef>

#include <rsh/rsh_types.h>

namespace bench {

enum class Difference {
    kNone,
    kSameDistance,  // another triangle as near: coplanar, or a shared edge
    kEdge,          // the nearer hit is at its triangle's edge, where the other one passed
    kGrazing,       // the same triangle, but t or the hit itself is lost in rounding
    kOther
};

struct DifferenceCounts {
    size_t same_distance = 0, edge = 0, grazing = 0, other = 0;
    void add(Difference difference);
    size_t all() const { return same_distance + edge + grazing + other; }
};

// Of one ray's closest hits. `cosine` is that between ray and the nearer hit's triangle.
Difference compare(const rsh_hit& ours, const rsh_hit& theirs, float cosine);

}  // namespace bench
