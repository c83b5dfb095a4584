// layout.hpp - how large the BVH of so many triangles is, and where things lie in it. Needs
// nothing but bvh/types.h: tests read the same.
#pragma once

#include <algorithm>

#include "bvh/types.h"

namespace rsh {

// Room for leaves of 14 triangles on the average and three more, or of 8 each
// (bvh/leaf_builder.h). Nodes have at least 8 children, but for the last node of a part or of a
// level (bvh/nodes_from_ranges.h); those out of the tree have 9 on the average
// (bvh/collapse16.h).
constexpr rsh_uint kLeastPart = 256, kMostPart = 8192;

inline bvh_layout bvh_layout_of(rsh_uint triangle_count) {
    constexpr rsh_uint kMostLevels = 9;
    bvh_layout layout = {};
    layout.triangles = triangle_count;
    layout.part = std::clamp((triangle_count / 16 + 15) & ~15u, kLeastPart, kMostPart);
    layout.parts = (triangle_count + layout.part - 1) / layout.part;
    const rsh_uint most = std::min(layout.part, triangle_count);
    layout.part_leaves = std::min(most / 14 + 3, most / 8 + 1);
    layout.part_nodes = layout.part_leaves / 8 + 1;
    const rsh_uint ranges = layout.parts * layout.part_nodes / 7 + kMostLevels;
    const rsh_uint branches =
        std::min(RSH_PART_ROOTS * layout.parts, RSH_LEAVES(layout) / 8 + 1);
    layout.upper_nodes = std::max(ranges, branches);
    return layout;
}

// The most bytes that up to so many triangles take, where bytes_of(triangles) grows with the BVH. Its parts
// become larger by 16 triangles behind each 256 k + 15; with one triangle more, the last part may be nearly
// empty, and the BVH up to a sixteenth larger before. Looks at no fewer than seven eighths of them.
template <class BytesOf>
size_t most_bytes_up_to(rsh_uint triangles, BytesOf bytes_of) {
    size_t most = bytes_of(triangles);
    const rsh_uint last = std::min(triangles, 16 * kMostPart);
    for (rsh_uint full = (triangles - triangles / 8) / 256 * 256 + 15; full < last; full += 256)
        most = std::max(most, bytes_of(full));
    return most;
}

}  // namespace rsh
