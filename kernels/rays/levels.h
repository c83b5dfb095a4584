/* levels.h - where the nodes of a level lie; see rsh_levels.
 *
 * A kernel that looks up a level which varies copies its rsh_levels argument first: Mesa 22.3's
 * llvmpipe reads arguments at constant offsets only, and crashes at any other.
 */
#ifndef RSH_RAYS_LEVELS_H
#define RSH_RAYS_LEVELS_H

#include "rays/types.h"

/* Index, in its level, of child k of node `parent` of level + 1. Worked example, a grid 5 wide:
 * parent 4 of level 1 (3 wide) is (1, 1); its child 1 at level 0 is (3, 2): index 2 * 5 + 3. */
static uint child_index(const rsh_levels* levels, uint level, uint parent, uint k)
{
    if (levels->is_list) return 4 * parent + k;
    const uint x = parent % levels->width[level + 1], y = parent / levels->width[level + 1];
    return (2 * y + (k >> 1)) * levels->width[level] + 2 * x + (k & 1);
}

static bool child_exists(const rsh_levels* levels, uint level, uint parent, uint k)
{
    if (levels->is_list) return 4 * parent + k < levels->width[level];
    const uint x = parent % levels->width[level + 1], y = parent / levels->width[level + 1];
    return 2 * x + (k & 1) < levels->width[level] && 2 * y + (k >> 1) < levels->height[level];
}

/* While pairs travel down a grid, a node is named by row * 65536 + column: no division on the
 * way from parent to child, both halves double. In a list the name is the index. Rays, at level
 * 0, go by their index at last. */
static uint quad_index(const rsh_levels* levels, uint level, uint node)
{
    const uint first = levels->first_child_group[level];
    if (levels->is_list) return first + node;
    return first + (node >> 16) * levels->width[level + 1] + (node & 0xffffu);
}

/* Names of the four children at `level` of a node of level + 1. */
static uint4 child_names(const rsh_levels* levels, uint level, uint node)
{
    if (levels->is_list) return 4 * node + (uint4)(0, 1, 2, 3);
    if (level > 0) return 2 * node + (uint4)(0, 1, 0x10000, 0x10001);
    const uint width = levels->width[0];
    return 2 * ((node >> 16) * width + (node & 0xffffu)) + (uint4)(0, 1, width, width + 1);
}

#endif
