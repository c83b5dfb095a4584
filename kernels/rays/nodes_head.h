/* nodes_head.h - what nodes are of, said at their start: written by the kernel that makes the
 * lowest of them, looked at before anything else of them is believed. */
#ifndef RSH_RAYS_NODES_HEAD_H
#define RSH_RAYS_NODES_HEAD_H

#include "rays/types.h"

#define RSH_NODES_HEAD_WORDS 16

/* shape: of all places; counted: rays in a row that there are; made: RSH_..._MADE. */
static void write_nodes_head(ray_levels shape, uint counted, uint made, uint order_at,
                             __global void* nodes)
{
    __global nodes_head* head = (__global nodes_head*)nodes;
    head->made = made;
    head->width = shape.width[0];
    head->height = shape.height[0];
    head->is_list = shape.is_list;
    head->counted = counted;
    head->order_at = order_at;
}

static bool nodes_are_of(ray_levels shape, uint counted, uint made, __global const void* nodes)
{
    __global const nodes_head* head = (__global const nodes_head*)nodes;
    return head->made == made && head->width == shape.width[0] &&
           head->height == shape.height[0] && head->is_list == shape.is_list &&
           head->counted == counted;
}

/* The order of a list's rays; 0: their own. */
static __global const uint* order_in(__global const void* nodes)
{
    const uint at = ((__global const nodes_head*)nodes)->order_at;
    return at ? (__global const uint*)nodes + at : 0;
}

#endif
