/* scene_boxes.h - what rsh_bound makes for the bound `box`, and how to find one's way in it:
 *   clusters  rsh_box_levels::boxes[1] x rsh_cluster: the corners of 16 triangles each, which
 *             lie close together (order_triangles.cl)
 *   groups    rsh_box_levels::group_count x rsh_box_group, level by level from 1 on. Box i of
 *             level 1 is around cluster i, that of level l + 1 around group i of level l
 *   order     a word per triangle: its number, by its place in the clusters
 *   scaled    a word per 16 clusters, a bit each: it has triangles that intersect.h scales
 *   surveys   RSH_SURVEYS x rsh_survey, of the order when it was made
 */
#ifndef RSH_SCENE_BOXES_H
#define RSH_SCENE_BOXES_H

#include "kernel_types.h"

#define RSH_CLUSTER_WORDS 144ul
#define RSH_GROUP_WORDS 96ul

static ulong cluster_at(uint cluster) { return RSH_CLUSTER_WORDS * cluster; }

static ulong box_group_at(const rsh_box_levels* levels, uint level, uint group)
{
    return RSH_CLUSTER_WORDS * levels->boxes[1] +
           RSH_GROUP_WORDS * (levels->first_group[level] + group);
}

static ulong order_at(const rsh_box_levels* levels)
{
    return RSH_ORDER_AT(*levels);
}

static ulong scaled_at(const rsh_box_levels* levels)
{
    return order_at(levels) + levels->boxes[0];
}

static ulong surveys_at(const rsh_box_levels* levels)
{
    return RSH_SURVEYS_AT(*levels);
}

#endif
