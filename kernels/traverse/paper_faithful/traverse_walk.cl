/* traverse_walk.cl - finishes, depth first, the pairs of a level that its stream cannot hold.
 *   pairs[limit ...]  in   pairs with nodes of level + 1; those with the root are never so many
 *   skip              in   a triangle per ray that it does not hit; NULL: none
 *   hits, occlusion   out  as in traverse/paper_faithful/intersect.cl
 * Same tests and same hits as breadth first, in memory that does not grow: a work-item keeps a
 * short list of pairs per level and always continues with the deepest one, so that a list is
 * empty before the level above fills it again.
 */
#include "lanes/stride.h"
#include "traverse/paper_faithful/closest_hit_atomic.h"
#include "traverse/paper_faithful/test_pairs.h"

/* Pairs taken off a list at a time; they leave at most four times as many on the next. */
#define RSH_TAKEN (4 * RSH_PAIRS)

typedef struct walk_lists {
    stream_pair pairs[RSH_MAX_LEVELS + 1][4 * RSH_TAKEN]; /* by level of their nodes */
    uint count[RSH_MAX_LEVELS + 1];
    stream_pair hits[RSH_WIDTH]; /* level 0: wait until they fill a vector */
    uint hit_count;
} walk_lists;

static void add_pair(const hit_target* target, walk_lists* walk, uint level, stream_pair pair)
{
    if (level > 0) {
        walk->pairs[level][walk->count[level]++] = pair;
        return;
    }
    walk->hits[walk->hit_count++] = pair;
    if (walk->hit_count < RSH_WIDTH) return;
    intersect_pairs(target, walk->hits, RSH_WIDTH);
    walk->hit_count = 0;
}

/* Tests up to RSH_PAIRS pairs with nodes of level + 1 and lists the survivors at `level`. */
static void descend(const hit_target* target, const ray_levels* levels, uint level,
                    const stream_pair* pairs, uint count, __global const float4* bounds,
                    __global const uint* nodes, walk_lists* walk)
{
    stream_pair group[RSH_PAIRS];
    int survives[4 * RSH_PAIRS];
    for (uint i = 0; i < RSH_PAIRS; ++i) group[i] = pairs[min(i, count - 1)];
    test_pairs(levels, level, group, bounds, nodes, survives);
    for (uint i = 0; i < count; ++i) {
        uint name[4];
        vstore4(child_names(levels, level, group[i].node), 0, name);
        for (uint k = 0; k < 4; ++k)
            if (survives[4 * i + k])
                add_pair(target, walk, level, (stream_pair){group[i].triangle, name[k]});
    }
}

/* Empties the lists up to the one at `top`. */
static void walk_down(const hit_target* target, const ray_levels* levels, uint top,
                      __global const float4* bounds, __global const uint* nodes,
                      walk_lists* walk)
{
    uint level = top;
    while (true) {
        while (walk->count[level] == 0) {
            if (level == top) return;
            ++level;
        }
        const uint taken = min(walk->count[level], (uint)RSH_TAKEN);
        walk->count[level] -= taken;
        const stream_pair* pairs = walk->pairs[level] + walk->count[level];
        for (uint i = 0; i < taken; i += RSH_PAIRS)
            descend(target, levels, level - 1, pairs + i, min((uint)RSH_PAIRS, taken - i),
                    bounds, nodes, walk);
        if (level > 1) --level;
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_traverse_walk(ray_levels shape, uint level, uint limit, mesh_view mesh,
                                __global const float* vertices, __global const uint* indices,
                                __global const rsh_ray* rays, __global const uint* skip,
                                __global const float4* bounds, __global const uint* nodes,
                                __global const stream_pair* pairs,
                                __global const uint* pair_count, __global rsh_hit* hits,
                                __global uint* occlusion,
                                uint occlusion_bit RSH_FILTER_PARAMETERS RSH_BATCH_PARAMETERS)
{
    const ray_levels levels = shape;
    hit_list list = hit_list_in(hits, occlusion_bit, 1);
    const hit_target target = {
        {mesh, vertices, indices, rays, skip RSH_GIVEN_FILTER RSH_GIVEN_BATCH},
        hits,
        occlusion,
        occlusion_bit,
        &list};
    const uint total = pair_count[level + 1];
    if (total <= limit) return;
    walk_lists walk;
    for (uint l = 0; l <= RSH_MAX_LEVELS; ++l) walk.count[l] = 0;
    walk.hit_count = 0;
    const strided_range mine = my_elements(total - limit);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        add_pair(&target, &walk, level + 1, pairs[limit + i]);
        const bool is_last = i + mine.step >= mine.end;
        if (is_last || walk.count[level + 1] == RSH_TAKEN)
            walk_down(&target, &levels, level + 1, bounds, nodes, &walk);
    }
    if (walk.hit_count > 0) intersect_pairs(&target, walk.hits, walk.hit_count);
}
