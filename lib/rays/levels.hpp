// levels.hpp - the shape of a hierarchy, level by level from the rays up.
#pragma once

#include <rsh/rsh.h>

namespace rsh {

// Level 0 alone. A grid one pixel wide or high is a list as well: its children in a row.
rsh_levels ray_level(cl_uint width, cl_uint height);
// Adds the level above the topmost one, which is returned.
cl_uint add_level(rsh_levels& levels);
// 16 children per node, from blocks over tiles up to a root; first_child_group numbers their groups.
rsh_levels group_levels(cl_uint width, cl_uint height);

inline cl_ulong node_count(const rsh_levels& levels, cl_uint level) {
    return cl_ulong{levels.width[level]} * levels.height[level];
}

// Rays of a call.
inline cl_ulong ray_count(cl_uint width, cl_uint height) {
    return cl_ulong{width} * (height ? height : 1);
}

}  // namespace rsh
