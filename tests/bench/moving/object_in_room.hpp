// object_in_room.hpp - an object that moves in a room that stands still: the bounds of both beside
// those of the object alone, and the trace through two trees beside that through one.
#pragma once

#include "frame/ray_maker.hpp"
#include "results.hpp"

namespace bench::moving {

struct ObjectInRoom {
    int64_t still, moving;  // triangles
    Size size;              // of the picture
    size_t rounds;

    std::string case_name() const;
    nlohmann::json params() const;
};

// Metrics, medians over the rounds; ratios are taken round by round, and by processor time as well:
//   bound_ms, alone_ms, bound_ratio, bound_cpu_ratio        the refit of both, of the object alone
//   traverse_ms, one_tree_ms, traverse_ratio, traverse_cpu_ratio   two trees, one
//   differ        hits with other bits
//   is_within     whether the promises of docs/performance.md hold: the bounds at most 1.5 times the
//                 object's, or 0.15 ms more; the traversal at most 1.15 times that of one tree
Case measure(const Device& device, const ObjectInRoom& asked);
std::string as_text(const ObjectInRoom& asked, const Case& c);

}  // namespace bench::moving
