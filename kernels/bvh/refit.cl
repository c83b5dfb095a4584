/* refit.cl - fits leaves and nodes to triangles that moved, where the order of the triangles
 * stayed: every leaf keeps its triangles, every node its children.
 *   vertices, indices  in      triangles of the tree
 *   bvh                in/out  see bvh/layout.h
 *   child_boxes        -       boxes of the leaves, then of the nodes, by their numbers
 * Does nothing where the order is a new one: then bvh/leaves.cl has built. Numbers that the BVH
 * holds are brought within its layout: a buffer that something else wrote to leads nowhere
 * outside.
 */
#include "bvh/leaves.h"
#include "order/types.h"
#include "tuning.h"

/* first_triangle: of the tree. Returns whether mesh/intersect.h scales any of the triangles. */
RSH_CALLED static bool refit_leaf(mesh_view mesh, __global const float* vertices,
                                  __global const uint* indices, uint first_triangle,
                                  __global float* leaf, float* side)
{
    __global const uint* words = (__global const uint*)leaf + RSH_TRIANGLES_AT;
    uintv index[RSH_VECTORS], index_in_tree[RSH_VECTORS];
    for_each_vector(v) {
        const uintv word = load_lanes(words + RSH_WIDTH * v);
        const intv is_none = word == (uintv)(RSH_NO_HIT);
        index[v] = select(RSH_TRIANGLE_INDEX(word), word, as_uintv(is_none));
        index_in_tree[v] = select(index[v] - first_triangle, word, as_uintv(is_none));
    }
    corner_rows corners;
    boxes16 boxes;
    load_numbered_corners(mesh, vertices, indices, index_in_tree, &corners);
    boxes_of_corners(&corners, &boxes);
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis) {
        side[axis] = smallest_lane(boxes.low[axis]);
        side[3 + axis] = largest_lane(boxes.high[axis]);
    }
    pad_box(side);
    return store_triangles(&corners, index, leaf);
}

/* Boxes of a node's children, and the box around them all, which goes to nodes[number]. leaves,
 * nodes: the boxes of all leaves and nodes; those of the children are fitted already. */
RSH_CALLED static void refit_node(const bvh_layout* layout, uint number, __global float* bvh,
                                  __global const child_box* leaves, __global child_box* nodes)
{
    __global float* node = bvh + node_at(&layout->whole, number);
    __global uint* child = (__global uint*)node + RSH_CHILDREN_AT;
    float row[6][16];
    for (uint k = 0; k < 16; ++k) {
        const uint member = child[k];
        const bool is_there = member != RSH_NO_CHILD, is_leaf = member & RSH_IS_LEAF;
        const uint last = (is_leaf ? layout->whole.leaves : layout->whole.nodes) - 1;
        __global const child_box* of =
            (is_leaf ? leaves : nodes) + (is_there ? min(RSH_CHILD_NUMBER(member), last) : 0);
        for (uint f = 0; f < 6; ++f) row[f][k] = is_there ? of->side[f] : empty_side(f);
        if (is_there && is_leaf) child[k] = of->child;
    }
    for (uint f = 0; f < 6; ++f) {
        floatv v[RSH_VECTORS];
        for_each_vector(i) {
            v[i] = load_lanes(row[f] + RSH_WIDTH * i);
            store_whole(__global, v[i], node + 16 * f + RSH_WIDTH * i);
        }
        nodes[number].side[f] = f < 3 ? smallest_lane(v) : largest_lane(v);
    }
}

static node_range within(node_range range, uint first, uint end)
{
    return (node_range){max(range.first, first), min(range.end, end)};
}

/* A work-item refits the leaves of a part, then its nodes. */
RSH_FILLS_VECTORS
__kernel void rsh_refit(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, bvh_layout given_layout,
                        __global const sort_plan* sorting, __global float* bvh,
                        __global child_box* child_boxes)
{
    const bvh_layout layout = given_layout;
    const uint me = get_global_id(0);
    if (me >= layout.parts || sorting->is_needed) return;
    const bvh_part counts = bvh_parts(&layout, bvh)[me];
    const uint first = first_leaf(&layout, me);
    const uint end = first + min(counts.leaves, layout.part_leaves);
    for (uint c = first; c < end; ++c) {
        child_box around;
        expect_stores(bvh + leaf_at(c + RSH_AHEAD));
        const bool is_scaled = refit_leaf(mesh, vertices, indices, RSH_FIRST_TRIANGLE(layout),
                                          bvh + leaf_at(c), around.side);
        around.child = child_of_leaf(c, is_scaled);
        child_boxes[c] = around;
    }
    const node_range nodes =
        within(counts.nodes, first_node(&layout, me), first_node(&layout, me + 1));
    for (uint g = nodes.first; g < nodes.end; ++g)
        refit_node(&layout, g, bvh, child_boxes, child_boxes + layout.whole.leaves);
}

/* The nodes above leaves of several parts. */
__kernel void rsh_refit_upper_nodes(bvh_layout given_layout, __global const sort_plan* sorting,
                                    __global float* bvh, __global child_box* child_boxes)
{
    if (get_global_id(0) != 0 || sorting->is_needed) return;
    const bvh_layout layout = given_layout;
    const node_range nodes = within(head_of(bvh)->nodes[layout.tree],
                                    first_node(&layout, layout.parts), end_node(&layout));
    for (uint g = nodes.first; g < nodes.end; ++g)
        refit_node(&layout, g, bvh, child_boxes, child_boxes + layout.whole.leaves);
}
