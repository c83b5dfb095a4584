/* group_levels.h - hierarchies of branching 4, up to a root: the 16 children of a node are a group.
 * A node goes by its index in its level; see rsh_levels. */
#ifndef RSH_RAYS_GROUP_LEVELS_H
#define RSH_RAYS_GROUP_LEVELS_H

#include "rays/types.h"

#define RSH_NO_NODE 0xffffffffu

/* Index, in its level, of child k of node `parent` of level + 1; RSH_NO_NODE: outside. */
static uint child_of(const rsh_levels* levels, uint level, uint parent, uint k)
{
    const uint width = levels->width[level];
    if (levels->is_list) return 16 * parent + k < width ? 16 * parent + k : RSH_NO_NODE;
    const uint across = levels->width[level + 1];
    const uint x = 4 * (parent % across) + (k & 3), y = 4 * (parent / across) + (k >> 2);
    return x < width && y < levels->height[level] ? y * width + x : RSH_NO_NODE;
}

/* Index, at `level`, of the node that holds node `node` of level `from`; level >= from. Worked
 * example, a grid: column 13 at level 2 is column 3 at level 3. */
static uint ancestor_of(const rsh_levels* levels, uint from, uint node, uint level)
{
    if (levels->is_list) return node >> 4 * (level - from);
    const uint x = node % levels->width[from] >> 2 * (level - from);
    const uint y = node / levels->width[from] >> 2 * (level - from);
    return y * levels->width[level] + x;
}

#endif
