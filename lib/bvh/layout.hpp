// layout.hpp - how large the BVH of so many triangles is, and where things lie in it. Needs
// nothing but rsh.h and bvh/types.h: tests read the same.
#pragma once

#include <rsh/rsh.h>

#include <algorithm>
#include <array>

#include "bvh/types.h"

namespace rsh {

constexpr rsh_uint kLeastPart = 256, kMostPart = 8192;

// Room for leaves of 14 triangles on the average and three more, or of 8 each
// (bvh/leaf_builder.h). Nodes have at least 8 children, but for the last node of a part or of a
// level (bvh/nodes_from_ranges.h); those out of the tree have 9 on the average
// (bvh/collapse16.h).
inline bvh_layout tree_layout_of(rsh_uint tree, rsh_uint triangle_count) {
    constexpr rsh_uint kMostLevels = 9;
    bvh_layout layout = {};
    layout.tree = tree;
    if (triangle_count == 0) return layout;
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

// By RSH_..._TREE, one behind the other.
using BvhLayouts = std::array<bvh_layout, RSH_TREES>;

inline BvhLayouts bvh_layouts_of(const rsh_geometry& geometry) {
    const cl_uint all = geometry.triangle_count, still_triangles = geometry.still_triangles;
    bvh_layout still = tree_layout_of(RSH_STILL_TREE, still_triangles);
    bvh_layout moving = tree_layout_of(RSH_MOVING_TREE, all - still_triangles);
    const bool has_both = still.triangles && moving.triangles;
    moving.first_leaf = RSH_LEAVES(still);
    moving.first_node = RSH_NODES(still);
    still.whole = {all, still_triangles, moving.first_leaf + RSH_LEAVES(moving),
                   moving.first_node + RSH_NODES(moving) + has_both};
    moving.whole = still.whole;
    if (still.triangles)
        moving.words_before = static_cast<rsh_uint>(RSH_TREE_END(still) - RSH_ORDER_AT(still));
    return {still, moving};
}

inline bvh_whole bvh_whole_of(const rsh_geometry& geometry) {
    return bvh_layouts_of(geometry)[RSH_STILL_TREE].whole;
}

inline size_t bvh_words(const BvhLayouts& trees) {
    return RSH_TREE_END(trees[RSH_MOVING_TREE]);
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
