/* leaves.cl - what a part of the scene makes of its own triangles: leaves, and above them, for
 * this frame alone, nodes that are ranges of leaves along the curve. Where the BVH is kept over
 * frames (is_quality), bvh/nodes.cl makes nodes out of a binary tree instead, slower to make and
 * quicker to trace.
 *   vertices, indices  in      triangles of the tree
 *   samples            in      the scene's extent, from rsh_order
 *   bvh                in/out  see bvh/layout.h; in: the order of the triangles
 *   child_boxes        out     boxes of the leaves, then of the nodes, by their numbers
 * Does nothing where the order stayed the same: then bvh/refit.cl does.
 */
#include "bvh/leaf_builder.h"
#include "bvh/leaf_surface.h"
#include "bvh/nodes_from_ranges.h"

/* A work-item takes a part. */
RSH_FILLS_VECTORS
__kernel void rsh_leaves(mesh_view mesh, __global const float* vertices,
                         __global const uint* indices, bvh_layout given_layout,
                         __global const sort_plan* sorting, uint sample_count,
                         __global const sample_bounds* samples, uint is_quality,
                         __global float* bvh, __global child_box* child_boxes)
{
    const bvh_layout layout = given_layout;
    const uint me = get_global_id(0);
    if (me >= layout.parts) return; /* launch is rounded up to whole groups */
    if (!sorting->is_needed) return;
    __global const uint* order = (__global const uint*)bvh + RSH_ORDER_AT(layout);
    const float leaf_surface = leaf_surface_of(samples, sample_count, layout.triangles);
    leaf_builder part;
    part.row.count = part.leaves = part.cut = 0;
    part.first_leaf = first_leaf(&layout, me);
    part.first_triangle = RSH_FIRST_TRIANGLE(layout);
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
    if (!is_quality)
        counts->nodes = nodes_of_part(&layout, RSH_RANGE_NODE_COST * leaf_surface, me,
                                      part.leaves, bvh, child_boxes);
}
