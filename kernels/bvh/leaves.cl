/* leaves.cl - leaves of triangles that lie close together, and nodes of leaves and
 * nodes, up to one. For this frame alone, nodes are ranges along the curve as leaves are;
 * where they are to be kept, they come out of a binary tree, which pays over some frames.
 *   vertices, indices  in      triangles
 *   samples              in      the scene's extent, from rsh_order_measure
 *   bvh                in/out  see bvh/layout.h; in: the order of the triangles
 *   child_boxes              -       boxes around leaves, by their numbers, then around nodes
 *   tree               -       RSH_TREE_WORDS; see bvh/types.h
 * Nothing is done where the order is the one that there was: bvh/refit.cl.
 * Does not look at rays.
 */
#include "bvh/collapse16.h"
#include "bvh/leaf_cuts.h"
#include "bvh/nodes_from_ranges.h"
#include "bvh/ploc.h"
#include "order/sort.h"

/* What a range costs besides its surface, as a part of the scene's by the number of ranges. The
 * mean surface of leaves is 3 to 9 times that; between a tenth and two thirds of it, what
 * rays open hardly changes. */
#define RSH_LEAF_COST 1.5f
#define RSH_RANGE_NODE_COST (RSH_MEAN_RANGE * RSH_LEAF_COST) /* the same of nodes */

/* A leaf's share of the scene's surface; never 0, so that each has a cost. */
static float mean_leaf_surface(const sample_bounds* scene, uint triangles)
{
    const float surface = surface_of(scene->low, scene->high);
    return clamp(surface * RSH_MEAN_RANGE / (float)triangles, 1e-30f, RSH_MOST_SURFACE);
}

/* A part of the triangles on its way into leaves: some of them in a row. */
typedef struct leaf_builder {
    box_row row; /* boxes around triangles, not padded */
    float corner[9][RSH_WINDOW + 16];
    uint triangle[RSH_WINDOW + 16]; /* numbers */
    uint next, end;                 /* places of those not in the row yet */
    uint leaves, first_leaf;        /* made so far, and the number of the first */
    uint cut;                       /* triangles in these */
} leaf_builder;

/* leaves: where they will be stored, in bursts that should find their lines in the cache. */
static void load_triangles(leaf_builder* part, mesh_view mesh, __global const float* vertices,
                           __global const uint* indices, __global const uint* order,
                           __global const float* leaves)
{
    for (; part->row.count + 16 <= RSH_WINDOW && part->next < part->end; part->next += 16) {
        const uint at = part->row.count;
        corner_rows corners;
        boxes16 boxes;
        load_corners(mesh, vertices, indices, order, part->next, &corners);
        boxes_of_corners(&corners, &boxes);
        for (uint v = 0; v < RSH_VECTORS; ++v) {
#pragma unroll
            for (uint axis = 0; axis < 3; ++axis) {
                store_whole(__private, boxes.low[axis][v],
                            part->row.side[axis] + at + RSH_WIDTH * v);
                store_whole(__private, boxes.high[axis][v],
                            part->row.side[3 + axis] + at + RSH_WIDTH * v);
            }
#pragma unroll
            for (uint i = 0; i < 9; ++i)
                store_whole(__private, corners.row[i / 3][i % 3][v],
                            part->corner[i] + at + RSH_WIDTH * v);
            store_whole_uint(__private, triangles_from(mesh, order, part->next + RSH_WIDTH * v),
                             part->triangle + at + RSH_WIDTH * v);
        }
        expect_stores(leaves + leaf_at(part->first_leaf + part->leaves + at / 15));
        part->row.count += min(16u, part->end - part->next);
    }
}

/* A part with more leaves than it has room for goes on with full ones: at least 14 triangles
 * to each on the average, but for three. */
static void cut_triangles(leaf_builder* part, float leaf_cost)
{
    const bool is_last = part->next >= part->end;
    cut_row(&part->row, leaf_cost, is_last);
    uint done = part->cut;
    for (uint r = 0; r < part->row.range_count; ++r) done += part->row.range_length[r];
    if (14 * (part->leaves + part->row.range_count) > done + 28)
        cut_evenly(&part->row, is_last);
}

/* Returns whether mesh/intersect.h has any of the triangles to scale. */
static bool store_leaf(const leaf_builder* part, uint first, uint length, __global float* leaf)
{
    corner_rows corners;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const intv is_there = RSH_LANES + (int)(RSH_WIDTH * v) < (intv)((int)length);
#pragma unroll
        for (uint i = 0; i < 9; ++i)
            corners.row[i / 3][i % 3][v] =
                select((floatv)(INFINITY), load_lanes(part->corner[i] + first + RSH_WIDTH * v),
                       is_there);
        const uintv triangle =
            select((uintv)(RSH_NO_HIT), load_lanes(part->triangle + first + RSH_WIDTH * v),
                   as_uintv(is_there));
        store_whole_uint(__global, triangle, leaf + RSH_TRIANGLES_AT + RSH_WIDTH * v);
    }
    store_corners(&corners, leaf);
    return is_any_scaled(&corners);
}

static void clear_leaves(__global float* leaf, uint count)
{
    for (; count > 0; --count, leaf += RSH_LEAF_WORDS) {
        for (uint i = 0; i < 9; ++i) vstore16((float16)(INFINITY), i, leaf);
        vstore16((uint16)(RSH_NO_HIT), 0, (__global uint*)leaf + RSH_TRIANGLES_AT);
    }
}

/* And leaves the boxes around them in `child_boxes`. */
static void store_leaves(leaf_builder* part, __global float* bvh,
                         __global child_box* child_boxes)
{
    uint first = 0;
    for (uint r = 0; r < part->row.range_count; ++r) {
        const uint length = part->row.range_length[r];
        const uint leaf = part->first_leaf + part->leaves++;
        child_box around;
        bound_range(&part->row, first, length, around.side);
        pad_box(around.side);
        const bool is_scaled = store_leaf(part, first, length, bvh + leaf_at(leaf));
        around.child = child_of_leaf(leaf, is_scaled);
        child_boxes[leaf] = around;
        first += length;
    }
    part->cut += first;
    shift_row(&part->row, first);
    for (uint i = 0; i < 9; ++i) shift_words(part->corner[i], first, part->row.count);
    shift_words((float*)part->triangle, first, part->row.count);
}

/* Up to the highest branches of a part. */
static void grow_part(const binary_tree* tree, float node_cost, uint part, uint leaves)
{
    const uint first = part * tree->layout.part_leaves;
    active_nodes active = no_active_nodes(tree, part);
    for (uint c = 0; c < leaves; ++c) add_active_node(tree, &active, first + c);
    grow_tree(tree, node_cost, &active, RSH_LEAVES(tree->layout) + first, RSH_PART_ROOTS);
    __global tree_part* made = tree->parts + part;
    for (uint i = 0; i < active.count; ++i) made->root[i] = active.number[i];
    made->roots = active.count;
    made->waiting = RSH_NO_BRANCH;
    made->first_node = (part + 1) * tree->layout.part_nodes;
}

/* A work-item makes the leaves of a part, and the nodes or the tree above them. */
__kernel void rsh_leaves(mesh_view mesh, __global const float* vertices,
                         __global const uint* indices, bvh_layout given_layout,
                         __global const sort_plan* sorting, uint sample_count,
                         __global const sample_bounds* samples, uint is_quality,
                         __global float* bvh, __global child_box* child_boxes,
                         __global float* tree)
{
    const bvh_layout layout = given_layout;
    const uint me = get_global_id(0);
    if (me >= layout.parts) return; /* launch is rounded up to whole groups */
    if (!sorting->is_needed) return;
    __global const uint* order = (__global const uint*)bvh + RSH_ORDER_AT(layout);
    const sample_bounds scene = merged_bounds(samples, sample_count);
    const float leaf_surface = mean_leaf_surface(&scene, layout.triangles);
    leaf_builder part;
    part.row.count = part.leaves = part.cut = 0;
    part.first_leaf = me * layout.part_leaves;
    part.next = me * layout.part;
    part.end = min(part.next + layout.part, layout.triangles);
    while (part.next < part.end || part.row.count) {
        load_triangles(&part, mesh, vertices, indices, order, bvh);
        cut_triangles(&part, RSH_LEAF_COST * leaf_surface);
        store_leaves(&part, bvh, child_boxes);
    }
    __global bvh_part* counts = bvh_parts(&layout, bvh) + me;
    counts->leaves = part.leaves;
    clear_leaves(bvh + leaf_at(part.first_leaf + part.leaves),
                 layout.part_leaves - part.leaves);
    if (!is_quality) {
        counts->nodes = nodes_of_part(&layout, RSH_RANGE_NODE_COST * leaf_surface, me,
                                      part.leaves, bvh, child_boxes);
        return;
    }
    const binary_tree growing = tree_in(layout, child_boxes, tree);
    grow_part(&growing, RSH_TREE_NODE_COST * leaf_surface, me, part.leaves);
}

/* Nodes of the parts' nodes; one work-item: there are 200 times fewer than triangles. */
__kernel void rsh_nodes_from_ranges(bvh_layout given_layout, __global const sort_plan* sorting,
                                    uint sample_count, __global const sample_bounds* samples,
                                    __global float* bvh, __global child_box* child_boxes)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const bvh_layout layout = given_layout;
    const sample_bounds scene = merged_bounds(samples, sample_count);
    const float node_cost = RSH_RANGE_NODE_COST * mean_leaf_surface(&scene, layout.triangles);
    const node_range nodes =
        nodes_above_parts(&layout, RSH_MEAN_RANGE * node_cost, bvh, child_boxes);
    *head_of(bvh) = (bvh_head){RSH_BVH_MADE, layout, nodes};
}

/* The tree above the parts, and the nodes at its top; one work-item: a part leaves 4 boxes. */
__kernel void rsh_nodes_tree_top(bvh_layout given_layout, __global const sort_plan* sorting,
                                 uint sample_count, __global const sample_bounds* samples,
                                 __global float* bvh, __global const child_box* child_boxes,
                                 __global float* tree)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const bvh_layout layout = given_layout;
    const sample_bounds scene = merged_bounds(samples, sample_count);
    const float node_cost = RSH_TREE_NODE_COST * mean_leaf_surface(&scene, layout.triangles);
    const binary_tree growing = tree_in(layout, child_boxes, tree);
    active_nodes active = no_active_nodes(&growing, layout.parts);
    for (uint p = 0; p < layout.parts; ++p)
        for (uint i = 0; i < growing.parts[p].roots; ++i)
            add_active_node(&growing, &active, growing.parts[p].root[i]);
    grow_tree(&growing, node_cost, &active, 2 * RSH_LEAVES(layout), 1);
    __global tree_part* above = growing.parts + layout.parts;
    const uint end = RSH_NODES(layout);
    above->waiting = RSH_NO_BRANCH;
    above->first_node = end - 1;
    make_node(&growing, active.number[0], end - 1, bvh);
    make_waiting_nodes(&growing, above, bvh);
    *head_of(bvh) = (bvh_head){0, layout, {above->first_node, end}};
}

/* What a part has, and will be read in no order. */
static void expect_part(const binary_tree* tree, uint part)
{
#ifdef RSH_EXPECT_LOAD
    const uint room = tree->layout.part_leaves, first = part * room;
    for (uint i = 0; i < room; ++i) RSH_EXPECT_LOAD(tree->branches + first + i);
    for (uint i = 0; i < room; i += 2) RSH_EXPECT_LOAD(tree->leaves + first + i);
#endif
}

/* A work-item makes the nodes of a part. Nothing is left to be done after that. */
__kernel void rsh_nodes_tree_parts(bvh_layout given_layout, __global const sort_plan* sorting,
                                   __global float* bvh, __global const child_box* child_boxes,
                                   __global float* tree)
{
    const bvh_layout layout = given_layout;
    const uint me = get_global_id(0);
    if (me >= layout.parts) return; /* launch is rounded up to whole groups */
    if (!sorting->is_needed) return;
    const binary_tree grown = tree_in(layout, child_boxes, tree);
    expect_part(&grown, me);
    make_waiting_nodes(&grown, grown.parts + me, bvh);
    bvh_parts(&layout, bvh)[me].nodes =
        (node_range){grown.parts[me].first_node, (me + 1) * layout.part_nodes};
    if (me == 0) head_of(bvh)->made = RSH_BVH_MADE;
}
