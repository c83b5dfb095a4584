// scene_shape.hpp - where things lie in what the bound `box` makes of a scene. Needs nothing but
// kernel_types.h: tests read the same.
#pragma once

#include <algorithm>

#include "kernel_types.h"

namespace rsh {

// Room for runs of 14 triangles on the average and three more, or of 8 each; groups have 8
// members and more but for the last of a part, or of a level (bound_boxes.cl).
inline rsh_scene_shape scene_shape(rsh_uint triangle_count) {
    constexpr rsh_uint kLeastPart = 256, kMostPart = 8192, kMostLevels = RSH_MAX_BOX_LEVELS;
    rsh_scene_shape shape = {};
    shape.triangles = triangle_count;
    shape.part = std::clamp((triangle_count / 16 + 15) & ~15u, kLeastPart, kMostPart);
    shape.parts = (triangle_count + shape.part - 1) / shape.part;
    const rsh_uint most = std::min(shape.part, triangle_count);
    shape.part_clusters = std::min(most / 14 + 3, most / 8 + 1);
    shape.part_groups = shape.part_clusters / 8 + 1;
    shape.upper_groups = shape.parts * shape.part_groups / 7 + kMostLevels;
    return shape;
}

}  // namespace rsh
