/* nodes.cl - the nodes above the leaves of several parts, and all nodes that come out of the
 * binary tree, with that tree.
 *   samples      in      the scene's extent, from rsh_order
 *   bvh          in/out  see bvh/layout.h; in: the leaves
 *   child_boxes  in/out  boxes of the leaves, then of the nodes, by their numbers
 *   tree         in/out  RSH_TREE_WORDS
 * Does nothing where the order of the triangles stayed the same.
 */
#include "bvh/collapse16.h"
#include "bvh/leaf_surface.h"
#include "bvh/nodes_from_ranges.h"
#include "bvh/ploc.h"

/* Ranges of the parts' nodes, of these, and so on, up to one node. One work-item: the parts
 * have 200 times fewer nodes than triangles. */
RSH_FILLS_VECTORS
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
    head_of(bvh)->nodes[layout.tree] = nodes;
    head_of(bvh)->made[layout.tree] = RSH_BVH_MADE;
}

/* Grows the tree of a part, up to RSH_PART_ROOTS roots. */
RSH_CALLED static void grow_part(const binary_tree* tree, float node_cost, uint part,
                                 uint leaves)
{
    const uint first = part * tree->layout.part_leaves;
    active_nodes active = no_active_nodes(tree, part);
    for (uint c = 0; c < leaves; ++c) add_active_node(tree, &active, first + c);
    grow_tree(tree, node_cost, &active, RSH_LEAVES(tree->layout) + first, RSH_PART_ROOTS);
    __global tree_part* made = tree->parts + part;
    for (uint i = 0; i < active.count; ++i) made->root[i] = active.number[i];
    made->roots = active.count;
    made->waiting = RSH_NO_BRANCH;
    made->first_node = first_node(&tree->layout, part + 1);
}

/* Grows the tree above the roots of the parts, and makes the nodes at its top. A part has at most 4
 * roots. */
RSH_CALLED static void make_top(const binary_tree* tree, float node_cost, __global float* bvh)
{
    active_nodes active = no_active_nodes(tree, tree->layout.parts);
    for (uint p = 0; p < tree->layout.parts; ++p)
        for (uint i = 0; i < tree->parts[p].roots; ++i)
            add_active_node(tree, &active, tree->parts[p].root[i]);
    grow_tree(tree, node_cost, &active, 2 * RSH_LEAVES(tree->layout), 1);
    __global tree_part* above = tree->parts + tree->layout.parts;
    const uint end = end_node(&tree->layout);
    above->waiting = RSH_NO_BRANCH;
    above->first_node = end - 1;
    make_node(tree, active.number[0], end - 1, bvh);
    make_waiting_nodes(tree, above, bvh);
    head_of(bvh)->nodes[tree->layout.tree] = (node_range){above->first_node, end};
}

/* Asks for the cache lines of a part that will be read in no order. */
static void expect_part(const binary_tree* tree, uint part)
{
    const uint room = tree->layout.part_leaves, first = part * room;
    for (uint i = 0; i < room; ++i) RSH_EXPECT_LOAD(tree->branches + first + i);
    for (uint i = 0; i < room; i += 2) RSH_EXPECT_LOAD(tree->leaves + first + i);
}

RSH_CALLED static void make_part(const binary_tree* tree, uint part, __global float* bvh)
{
    expect_part(tree, part);
    make_waiting_nodes(tree, tree->parts + part, bvh);
    bvh_parts(&tree->layout, bvh)[part].nodes =
        (node_range){tree->parts[part].first_node, first_node(&tree->layout, part + 1)};
    if (part == 0) head_of(bvh)->made[tree->layout.tree] = RSH_BVH_MADE;
}

/* Launched for each tree_pass. Afterwards the BVH is complete. */
RSH_FILLS_VECTORS
__kernel void rsh_nodes_tree(bvh_layout given_layout, __global const sort_plan* sorting,
                             uint sample_count, __global const sample_bounds* samples,
                             uint pass, __global float* bvh,
                             __global const child_box* child_boxes, __global float* tree)
{
    const bvh_layout layout = given_layout;
    const uint me = get_global_id(0);
    if (me >= layout.parts) return; /* launch is rounded up to whole groups */
    if (!sorting->is_needed) return;
    const binary_tree growing = tree_in(layout, child_boxes + layout.first_leaf, tree);
    if (pass == RSH_NODES_PASS) {
        make_part(&growing, me, bvh);
        return;
    }
    const float node_cost =
        RSH_TREE_NODE_COST * leaf_surface_of(samples, sample_count, layout.triangles);
    if (pass == RSH_GROW_PASS)
        grow_part(&growing, node_cost, me, bvh_parts(&layout, bvh)[me].leaves);
    else
        make_top(&growing, node_cost, bvh);
}
