/* levels.h - where the nodes of a level lie; see rsh_levels. */
#ifndef RSH_LEVELS_H
#define RSH_LEVELS_H

#include "kernel_types.h"

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

#endif
