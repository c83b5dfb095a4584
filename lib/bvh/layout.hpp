// layout.hpp - where things lie in what the bound `box` makes of a scene. Needs nothing but
// bvh/types.h: tests read the same.
#pragma once

#include <algorithm>

#include "bvh/types.h"

namespace rsh {

// Room for runs of 14 triangles on the average and three more, or of 8 each (bvh/leaves.cl).
// Groups hold 8 and more but for the last of a part, or of a level (bvh/nodes_from_runs.h), or on the
// average (bvh/collapse16.h).
inline rsh_scene_shape scene_shape(rsh_uint triangle_count) {
    constexpr rsh_uint kLeastPart = 256, kMostPart = 8192, kMostLevels = 9;
    rsh_scene_shape shape = {};
    shape.triangles = triangle_count;
    shape.part = std::clamp((triangle_count / 16 + 15) & ~15u, kLeastPart, kMostPart);
    shape.parts = (triangle_count + shape.part - 1) / shape.part;
    const rsh_uint most = std::min(shape.part, triangle_count);
    shape.part_clusters = std::min(most / 14 + 3, most / 8 + 1);
    shape.part_groups = shape.part_clusters / 8 + 1;
    const rsh_uint runs = shape.parts * shape.part_groups / 7 + kMostLevels;
    const rsh_uint branches =
        std::min(RSH_PART_TOPS * shape.parts, RSH_CLUSTERS(shape) / 8 + 1);
    shape.upper_groups = std::max(runs, branches);
    return shape;
}

}  // namespace rsh
