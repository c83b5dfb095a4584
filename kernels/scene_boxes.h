/* scene_boxes.h - what rsh_bound makes for the bound `box`, and how to find one's way in it:
 *   groups    rsh_box_levels::group_count x rsh_box_group, level by level
 *   children  a word per cluster: its group of level 0. Level 1 is in Morton order, so that
 *             runs of 16 clusters lie close together even where the triangles jump from object
 *             to object; level 0 stays where it is. Above, box i has the children group i.
 *   order     a word per triangle, if is_ordered: the triangle in that place of level 0
 *   is_ordered    a word
 *   cluster_size  a float: the surface of a typical cluster's box, three of its sides
 */
#ifndef RSH_SCENE_BOXES_H
#define RSH_SCENE_BOXES_H

#include "kernel_types.h"

#define RSH_GROUP_WORDS 96ul

static ulong children_at(rsh_box_levels levels) { return RSH_GROUP_WORDS * levels.group_count; }
static ulong order_at(rsh_box_levels levels)
{
    return children_at(levels) + levels.boxes[1];
}
static ulong is_ordered_at(rsh_box_levels levels) { return order_at(levels) + levels.boxes[0]; }

static ulong cluster_size_at(rsh_box_levels levels) { return is_ordered_at(levels) + 1; }

/* The triangle in a place of level 0. */
static uint triangle_in(__global const uint* boxes, rsh_box_levels levels, uint place)
{
    return boxes[is_ordered_at(levels)] ? boxes[order_at(levels) + place] : place;
}

#endif
