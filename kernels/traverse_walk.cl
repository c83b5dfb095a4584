/* traverse_walk.cl - finishes, depth first, the pairs of a level that its stream cannot hold.
 *   pairs[limit ...]  in   pairs with nodes of level + 1
 *   hits, occlusion   out  as in intersect.cl
 * Needs no memory that grows: a stack of one entry per level. Same tests, same hits as breadth first.
 */
#include "candidates.h"
#include "cone_sphere.h"
#include "levels.h"
#include "stride.h"

/* Pairs at level 0 wait here until a whole vector of them can be intersected. */
typedef struct rsh_waiting {
    rsh_pair pairs[RSH_WIDTH];
    uint count;
} rsh_waiting;

static void add_waiting(const rsh_target* target, rsh_waiting* waiting, rsh_pair pair)
{
    waiting->pairs[waiting->count++] = pair;
    if (waiting->count < RSH_WIDTH) return;
    intersect_pairs(target, waiting->pairs, RSH_WIDTH);
    waiting->count = 0;
}

static void walk(const rsh_target* target, const rsh_levels* levels, uint level, rsh_pair pair,
                 float4 sphere, __global const rsh_node_quad* quads, rsh_waiting* waiting)
{
    uint node[RSH_MAX_LEVELS];  /* parent whose children are at level l */
    uint todo[RSH_MAX_LEVELS];  /* its children still to visit */
    uint l = level;
    node[l] = pair.node;
    todo[l] = children_that_meet(quads + quad_index(levels, l, pair.node), sphere);
    while (true) {
        if (todo[l] == 0) {
            if (l == level) return;
            ++l;
            continue;
        }
        const uint k = popcount((todo[l] & -todo[l]) - 1); /* lowest bit */
        todo[l] &= todo[l] - 1;
        const uint4 names = child_names(levels, l, node[l]);
        const uint child = k < 2 ? (k == 0 ? names.x : names.y) : (k == 2 ? names.z : names.w);
        if (l == 0) {
            add_waiting(target, waiting, (rsh_pair){pair.triangle, child});
            continue;
        }
        --l;
        node[l] = child;
        todo[l] = children_that_meet(quads + quad_index(levels, l, child), sphere);
    }
}

__kernel void rsh_traverse_walk(rsh_levels levels, uint level, uint limit, rsh_mesh mesh,
                                __global const float* vertices, __global const uint* indices,
                                __global const rsh_ray* rays, __global const float4* spheres,
                                __global const rsh_node_quad* quads,
                                __global const rsh_pair* pairs, __global const uint* pair_count,
                                __global rsh_hit* hits, __global uint* occlusion,
                                uint occlusion_bit)
{
    const rsh_target target = {mesh, vertices, indices, rays, hits, occlusion, occlusion_bit};
    const uint total = pair_count[level + 1];
    if (total <= limit) return;
    rsh_waiting waiting;
    waiting.count = 0;
    const rsh_stride mine = my_elements(total - limit);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const rsh_pair pair = pairs[limit + i];
        walk(&target, &levels, level, pair, spheres[pair.triangle], quads, &waiting);
    }
    if (waiting.count > 0) intersect_pairs(&target, waiting.pairs, waiting.count);
}
