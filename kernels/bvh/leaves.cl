/* leaves.cl - what a part of the scene makes of its own triangles: leaves, and above them
 * either nodes that are ranges of leaves along the curve, for this frame alone, or a binary
 * tree, for a BVH that is kept over frames: nodes out of it (bvh/nodes.cl) are slower to make
 * and quicker to trace.
 *   vertices, indices  in      triangles
 *   samples            in      the scene's extent, from rsh_order_measure
 *   bvh                in/out  see bvh/layout.h; in: the order of the triangles
 *   child_boxes        out     boxes of the leaves, then of the nodes, by their numbers
 *   tree               out     RSH_TREE_WORDS
 * Does nothing where the order stayed the same: then bvh/refit.cl does.
 */
#include "bvh/leaf_builder.h"
#include "bvh/leaf_surface.h"
#include "bvh/nodes_from_ranges.h"
#include "bvh/ploc.h"

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
    made->first_node = (part + 1) * tree->layout.part_nodes;
}

/* A work-item takes a part. */
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
