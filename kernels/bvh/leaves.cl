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
#include "bvh/leaf_builder.h"
#include "bvh/leaf_surface.h"
#include "bvh/nodes_from_ranges.h"
#include "bvh/ploc.h"

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
    const float leaf_surface = leaf_surface_of(samples, sample_count, layout.triangles);
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
