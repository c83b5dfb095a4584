/* levels.h - where the nodes of a level lie, and how they are named on the way down; see
 * ray_levels.
 *
 * A kernel that looks up a level which varies copies its ray_levels argument first: Mesa 22.3's
 * llvmpipe reads arguments at constant offsets only, and crashes at any other.
 */
#ifndef RSH_RAYS_LEVELS_H
#define RSH_RAYS_LEVELS_H

#include "rays/types.h"

#define RSH_NO_NODE 0xffffffffu

/* log2 of ray_levels::branching, which is 2 or 4. */
static uint branching_bits(const ray_levels* levels) { return levels->branching / 2; }

/* Of `most` rays, those that there are: the device may know of fewer. list_count: 0: all. */
static uint counted_rays(uint most, __global const uint* list_count)
{
    return list_count ? min(*list_count, most) : most;
}

/* The levels of those rays of a list that there are. Nodes stay at their places, so that
 * first_child_group does; the root is as low as it can be. */
static ray_levels counted_levels(ray_levels levels, __global const uint* list_count)
{
    if (!list_count) return levels;
    const uint bits = branching_bits(&levels);
    levels.width[0] = counted_rays(levels.width[0], list_count);
    for (uint l = 1; l <= RSH_MAX_LEVELS; ++l) {
        levels.width[l] = (levels.width[l - 1] + (1u << 2 * bits) - 1) >> 2 * bits;
        /* Boxes have two levels at least, cones one. */
        if (l >= bits && levels.width[l] <= 1) levels.count = min(levels.count, l);
    }
    return levels;
}

/* Index, in its level, of child k of node `parent` of level + 1; RSH_NO_NODE: the level has no
 * such node. Worked example, a grid 5 wide, branching 2: parent 4 of level 1 (3 wide) is (1,
 * 1); its child 1 at level 0 is (3, 2): index 2 * 5 + 3. */
static uint child_of(const ray_levels* levels, uint level, uint parent, uint k)
{
    const uint bits = branching_bits(levels), width = levels->width[level];
    if (levels->is_list) {
        const uint child = (parent << 2 * bits) + k;
        return child < width ? child : RSH_NO_NODE;
    }
    const uint across = levels->width[level + 1];
    const uint x = (parent % across << bits) + (k & (levels->branching - 1));
    const uint y = (parent / across << bits) + (k >> bits);
    return x < width && y < levels->height[level] ? y * width + x : RSH_NO_NODE;
}

/* Index, at `level`, of the node that holds node `node` of level `from`; level >= from. Worked
 * example, a grid, branching 4: column 13 at level 2 is column 3 at level 3. */
static uint ancestor_of(const ray_levels* levels, uint from, uint node, uint level)
{
    const uint bits = branching_bits(levels) * (level - from);
    if (levels->is_list) return node >> 2 * bits;
    const uint x = node % levels->width[from] >> bits;
    const uint y = node / levels->width[from] >> bits;
    return y * levels->width[level] + x;
}

/* The pairs of the engine `paper_faithful`, whose nodes have four children, name nodes of a
 * grid by row * 65536 + column: no division on the way from parent to child, both halves
 * double. In a list the name is the index. Rays, at level 0, are named by their index at
 * last. */
static uint quad_index(const ray_levels* levels, uint level, uint node)
{
    const uint first = levels->first_child_group[level];
    if (levels->is_list) return first + node;
    return first + (node >> 16) * levels->width[level + 1] + (node & 0xffffu);
}

/* Names of the four children at `level` of a node of level + 1. */
static uint4 child_names(const ray_levels* levels, uint level, uint node)
{
    if (levels->is_list) return 4 * node + (uint4)(0, 1, 2, 3);
    if (level > 0) return 2 * node + (uint4)(0, 1, 0x10000, 0x10001);
    const uint width = levels->width[0];
    return 2 * ((node >> 16) * width + (node & 0xffffu)) + (uint4)(0, 1, width, width + 1);
}

#endif
