/* nodes_from_ranges.h - nodes that are ranges of leaves along the curve, 8 to 16 each, cut like
 * the leaves themselves; then nodes that are ranges of these, up to one. A tenth of the work
 * that the binary tree of bvh/binary_tree.h is, but single rays visit more nodes. Nodes are
 * numbered from the first one up, so that a node's children come before it.
 */
#ifndef RSH_BVH_NODES_FROM_RANGES_H
#define RSH_BVH_NODES_FROM_RANGES_H

#include "bvh/leaf_cuts.h"
#include "bvh/leaves.h"

/* A level of nodes while it is made: the boxes of its children pass through a row. */
typedef struct level_builder {
    box_row row;
    uint child[RSH_WINDOW + 16];
    float node_cost;
    uint next_node; /* the number that the next node gets */
} level_builder;

static void store_node(const level_builder* level, uint first, uint length,
                       __global float* node)
{
    for_each_vector(v) {
        const intv is_there = RSH_LANES + (int)(RSH_WIDTH * v) < (intv)((int)length);
#pragma unroll
        for (uint f = 0; f < 6; ++f)
            store_lanes(
                select((floatv)(empty_side(f)),
                       load_lanes(level->row.side[f] + first + RSH_WIDTH * v), is_there),
                node + 16 * f + RSH_WIDTH * v);
        store_lanes(
            select((uintv)(RSH_NO_CHILD), load_lanes(level->child + first + RSH_WIDTH * v),
                   as_uintv(is_there)),
            (__global uint*)node + RSH_CHILDREN_AT + RSH_WIDTH * v);
    }
}

/* Stores the ranges of the row as nodes, and the boxes around them in child_boxes. */
static void store_nodes(level_builder* level, const bvh_layout* layout, __global float* bvh,
                        __global child_box* child_boxes)
{
    uint first = 0;
    for (uint r = 0; r < level->row.range_count; ++r) {
        const uint length = level->row.range_length[r], node = level->next_node++;
        store_node(level, first, length, bvh + node_at(&layout->whole, node));
        child_box around;
        bound_range(&level->row, first, length, around.side);
        around.child = node;
        child_boxes[layout->whole.leaves + node] = around;
        first += length;
    }
    shift_row(&level->row, first);
    shift_words((float*)level->child, first, level->row.count);
}

/* Adds the boxes first .. end - 1 of child_boxes; the last ones may wait in the row. */
static void add_boxes_from(level_builder* level, uint first, uint end, const bvh_layout* layout,
                           __global float* bvh, __global child_box* child_boxes)
{
    for (uint i = first; i < end; ++i) {
        if (level->row.count == RSH_WINDOW) {
            cut_row(&level->row, level->node_cost, false);
            store_nodes(level, layout, bvh, child_boxes);
        }
        const uint at = level->row.count++;
        for (uint f = 0; f < 6; ++f) level->row.side[f][at] = child_boxes[i].side[f];
        level->child[at] = child_boxes[i].child;
    }
}

/* At the top, a level that fits into one node becomes one. */
static void end_level(level_builder* level, bool is_top, const bvh_layout* layout,
                      __global float* bvh, __global child_box* child_boxes)
{
    if (is_top && level->row.count <= 16)
        cut_evenly(&level->row, true);
    else
        cut_row(&level->row, level->node_cost, true);
    store_nodes(level, layout, bvh, child_boxes);
}

static void begin_levels(level_builder* level, float node_cost, uint first_node)
{
    level->row.count = 0;
    level->node_cost = fmin(node_cost, RSH_MOST_SURFACE);
    level->next_node = first_node;
}

/* One level of nodes above the leaves of a part. */
RSH_CALLED static node_range nodes_of_part(const bvh_layout* layout, float node_cost, uint part,
                                           uint leaves, __global float* bvh,
                                           __global child_box* child_boxes)
{
    const uint first = first_leaf(layout, part);
    node_range made = {first_node(layout, part), 0};
    level_builder level;
    begin_levels(&level, node_cost, made.first);
    add_boxes_from(&level, first, first + leaves, layout, bvh, child_boxes);
    end_level(&level, false, layout, bvh, child_boxes);
    made.end = level.next_node;
    return made;
}

/* All levels above the nodes of the parts. */
RSH_CALLED static node_range nodes_above_parts(const bvh_layout* layout, float node_cost,
                                               __global float* bvh,
                                               __global child_box* child_boxes)
{
    node_range made = {first_node(layout, layout->parts), 0};
    level_builder level;
    begin_levels(&level, node_cost, made.first);
    const uint nodes_at = layout->whole.leaves;
    for (uint p = 0; p < layout->parts; ++p) {
        const node_range of = bvh_parts(layout, bvh)[p].nodes;
        add_boxes_from(&level, nodes_at + of.first, nodes_at + of.end, layout, bvh,
                       child_boxes);
    }
    end_level(&level, true, layout, bvh, child_boxes);
    for (uint first = made.first; level.next_node - first > 1;) {
        const uint end = level.next_node;
        level.node_cost = fmin(RSH_MEAN_RANGE * level.node_cost, RSH_MOST_SURFACE);
        add_boxes_from(&level, nodes_at + first, nodes_at + end, layout, bvh, child_boxes);
        end_level(&level, true, layout, bvh, child_boxes);
        first = end;
    }
    made.end = level.next_node;
    return made;
}

#endif
