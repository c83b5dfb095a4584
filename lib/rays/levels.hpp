// levels.hpp - the shape of a hierarchy, level by level from the rays up.
#pragma once

#include "rays/types.h"

namespace rsh {

// Nodes of the shape `cone`: 2 x 2 children each, up to a root.
ray_levels cone_levels(cl_uint width, cl_uint height);
// Nodes of the shape `box`: blocks of 4 x 4 rays and tiles of 4 x 4 blocks.
ray_levels box_levels(cl_uint width, cl_uint height);
// 16 children per node, from blocks over tiles up to a root; first_child_group numbers their
// groups.
ray_levels group_levels(cl_uint width, cl_uint height);

inline cl_ulong node_count(const ray_levels& levels, cl_uint level) {
    return cl_ulong{levels.width[level]} * levels.height[level];
}

// Rays of a call.
inline cl_ulong ray_count(cl_uint width, cl_uint height) {
    return cl_ulong{width} * (height ? height : 1);
}

}  // namespace rsh
