// differences.cpp - tolerances and the decision.
#include "frame/embree/differences.hpp"

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

constexpr float kDistance = 1e-4f;  // relative, of t
constexpr float kEdge = 1e-3f;      // of the barycentric coordinates
constexpr float kGrazing = 1e-2f;   // cosine below which rounding moves the hit far

bool is_near_edge(const rsh_hit& hit) {
    return std::min({hit.u, hit.v, 1.0f - hit.u - hit.v}) < kEdge;
}

bool is_same_distance(float a, float b, float tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

// Right at a ray's origin t is mostly rounding of the coordinates, while the place is not.
bool is_same_place(const rsh_hit& a, const rsh_hit& b) {
    return a.primitive == b.primitive && std::abs(a.u - b.u) < kEdge &&
           std::abs(a.v - b.v) < kEdge && is_same_distance(a.t, b.t, 100 * kDistance);
}

}  // namespace

void DifferenceCounts::add(Difference difference) {
    if (difference == Difference::kSameDistance) ++same_distance;
    if (difference == Difference::kEdge) ++edge;
    if (difference == Difference::kGrazing) ++grazing;
    if (difference == Difference::kOther) ++other;
}

Difference compare(const rsh_hit& ours, const rsh_hit& theirs, float cosine) {
    const bool hits_both = ours.primitive != RSH_NO_HIT && theirs.primitive != RSH_NO_HIT;
    const bool hits_none = ours.primitive == RSH_NO_HIT && theirs.primitive == RSH_NO_HIT;
    if (hits_none) return Difference::kNone;
    if (hits_both && is_same_place(ours, theirs)) return Difference::kNone;
    if (hits_both && is_same_distance(ours.t, theirs.t, kDistance))
        return ours.primitive == theirs.primitive ? Difference::kNone
                                                  : Difference::kSameDistance;
    const bool is_ours =
        theirs.primitive == RSH_NO_HIT || (ours.primitive != RSH_NO_HIT && ours.t < theirs.t);
    if (is_near_edge(is_ours ? ours : theirs)) return Difference::kEdge;
    return std::abs(cosine) < kGrazing ? Difference::kGrazing : Difference::kOther;
}

}  // namespace bench
