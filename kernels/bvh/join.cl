/* join.cl - the node above the tree of what stands still and that of what moves.
 *   bvh  in/out  see bvh/layout.h; in: both trees
 */
#include "bvh/layout.h"

/* The box around all children of a node, its boxes one after the other: low x y z, high x y z. */
static void bound_children(__global const float* node, float* side)
{
    for (uint f = 0; f < 6; ++f) {
        side[f] = empty_side(f);
        for (uint k = 0; k < 16; ++k)
            side[f] = f < 3 ? fmin(side[f], node[16 * f + k]) : fmax(side[f], node[16 * f + k]);
    }
}

/* One work-item. Does nothing where one of the trees is not there. */
__kernel void rsh_join_trees(bvh_whole given_whole, __global float* bvh)
{
    const bvh_whole whole = given_whole;
    if (get_global_id(0) != 0 || !has_trees_of(bvh, whole)) return;
    const uint last = whole.nodes - 1;
    __global float* node = bvh + node_at(&whole, last);
    for (uint k = 0; k < 16; ++k) {
        float side[6];
        uint child = RSH_NO_CHILD;
        for (uint f = 0; f < 6; ++f) side[f] = empty_side(f);
        if (k < RSH_TREES) {
            child = min(top_of_tree(bvh, k), last);
            bound_children(bvh + node_at(&whole, child), side);
        }
        for (uint f = 0; f < 6; ++f) node[16 * f + k] = side[f];
        ((__global uint*)node)[RSH_CHILDREN_AT + k] = child;
    }
    head_of(bvh)->joined = RSH_BVH_MADE;
}
