/* nodes.cl - the nodes above the leaves of several parts, and all nodes that come out of the
 * binary tree.
 *   samples      in      the scene's extent, from rsh_order_measure
 *   bvh          in/out  see bvh/layout.h; in: the leaves
 *   child_boxes  in/out  boxes of the leaves, then of the nodes, by their numbers
 *   tree         in/out  RSH_TREE_WORDS; in: as bvh/leaves.cl leaves it
 * Does nothing where the order of the triangles stayed the same.
 */
#include "bvh/collapse16.h"
#include "bvh/leaf_surface.h"
#include "bvh/nodes_from_ranges.h"
#include "bvh/ploc.h"

/* Ranges of the parts' nodes, of these, and so on, up to one node. One work-item: the parts
 * have 200 times fewer nodes than triangles. */
__kernel void rsh_nodes_from_ranges(bvh_layout given_layout, __global const sort_plan* sorting,
                                    uint sample_count, __global const sample_bounds* samples,
                                    __global float* bvh, __global child_box* child_boxes)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const bvh_layout layout = given_layout;
    const float node_cost =
        RSH_RANGE_NODE_COST * leaf_surface_of(samples, sample_count, layout.triangles);
    const node_range nodes =
        nodes_above_parts(&layout, RSH_MEAN_RANGE * node_cost, bvh, child_boxes);
    *head_of(bvh) = (bvh_head){RSH_BVH_MADE, layout, nodes, {0}};
}

/* The tree above the roots of the parts, and the nodes at its top. One work-item: a part has at
 * most 4 roots. */
__kernel void rsh_nodes_tree_top(bvh_layout given_layout, __global const sort_plan* sorting,
                                 uint sample_count, __global const sample_bounds* samples,
                                 __global float* bvh, __global const child_box* child_boxes,
                                 __global float* tree)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const bvh_layout layout = given_layout;
    const float node_cost =
        RSH_TREE_NODE_COST * leaf_surface_of(samples, sample_count, layout.triangles);
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
    *head_of(bvh) = (bvh_head){0, layout, {above->first_node, end}, {0}};
}

/* Asks for the cache lines of a part that will be read in no order. */
static void expect_part(const binary_tree* tree, uint part)
{
    const uint room = tree->layout.part_leaves, first = part * room;
    for (uint i = 0; i < room; ++i) RSH_EXPECT_LOAD(tree->branches + first + i);
    for (uint i = 0; i < room; i += 2) RSH_EXPECT_LOAD(tree->leaves + first + i);
}

/* A work-item makes the nodes of a part. Afterwards the BVH is complete. */
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
