/* group_levels.h - hierarchies of fan 4, up to a root: the 16 children of a node are a group.
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

typedef struct rsh_place {
    uint parent; /* of level + 1 */
    uint lane;   /* which of its children */
} rsh_place;

/* Where node `above` of `level` lies that holds a node of level `from`; level >= from. Worked
 * example, a grid: column 13 at level 2 is column 3 at level 3: child 3 of column 0. */
static rsh_place place_of(const rsh_levels* levels, uint from, uint node, uint level)
{
    if (levels->is_list) {
        const uint above = node >> 4 * (level - from);
        return (rsh_place){above >> 4, above & 15};
    }
    const uint x = node % levels->width[from] >> 2 * (level - from);
    const uint y = node / levels->width[from] >> 2 * (level - from);
    return (rsh_place){(y >> 2) * levels->width[level + 1] + (x >> 2),
                       4 * (y & 3) + (x & 3)};
}

#endif
