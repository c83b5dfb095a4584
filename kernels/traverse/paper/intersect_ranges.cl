/* intersect_ranges.cl - the last level of the engine `paper`: the 16 rays of a block against
 * the triangles of its range; and what the stream could not hold.
 *   triangles, ranges  in      of the blocks
 *   list_count         in      how many rays of a list there are; NULL: all
 *   skip               in      a triangle per ray that it does not hit; NULL: none
 *   hits               in/out  closest so far; at first those of traverse/clear_hits.cl
 *   occlusion          in/out  any: a bit per ray
 * With RSH_ALL_HITS, hits and occlusion are what traverse/hit_list.h says.
 * A work-item owns the rays that it writes, and launches follow each other: no atomics.
 */
#include "bvh/layout.h"
#include "lanes/stride.h"
#include "rays/nodes_head.h"
#include "traverse/count.h"
#include "traverse/paper/intersect_ranges.h"
#include "traverse/paper/ranges.h"
#include "traverse/paper/siblings.h"
#include "tuning.h"

/* A work-item takes the blocks of a tile. */
RSH_FILLS_VECTORS
__kernel void rsh_intersect_ranges(
    ray_levels shape, __global const uint* list_count, mesh_view mesh,
    __global const float* vertices, __global const uint* indices, __global const rsh_ray* rays,
    __global const uint* skip, __global const float* bounds, __global const float* nodes,
    __global const uint* triangles, __global const uint2* ranges, __global rsh_hit* hits,
    __global uint* occlusion, uint occlusion_bit RSH_FILTER_PARAMETERS RSH_BATCH_PARAMETERS)
{
    const ray_levels levels = counted_levels(shape, list_count);
    const uint me = my_element(tile_count(levels));
    if (me == tile_count(levels)) return;
    hit_list list = hit_list_in(hits, occlusion_bit, 1);
    const range_target target = {
        {mesh, vertices, indices, rays, skip RSH_GIVEN_FILTER RSH_GIVEN_BATCH},
        hits,
        occlusion,
        occlusion_bit,
        bounds,
        &list};
    const ray_tile tile = tile_at(levels, order_in(nodes), me);
    for (uint b = 0; b < 16; ++b) {
        const uint node = child_of(&levels, 1, me, b);
        if (node == RSH_NO_NODE || ranges[node].y == 0) continue;
        const uint2 range = ranges[node];
        ray_packet packet;
        bool is_changed = false;
        load_target_packet(&target, &tile, b, &packet);
        for (uint i = range.x; i < range.x + range.y; ++i)
            is_changed |= offer_triangle(&target, &packet, triangles[i]);
        if (is_changed) store_target_packet(&target, tile, b, &packet);
    }
}

/* Triangles that meet blocks of a tile are gathered, so that each block is loaded once for
 * many. */
typedef struct gathered_triangles {
    uint triangle[RSH_GATHERED];
    ushort met[RSH_GATHERED];
    uint count;
} gathered_triangles;

static void intersect_gathered(const range_target* target, ray_tile tile,
                               const gathered_triangles* gathered)
{
    for (uint b = 0; b < 16; ++b) {
        ray_packet packet;
        bool is_loaded = false, is_changed = false;
        for (uint i = 0; i < gathered->count; ++i) {
            if (!(gathered->met[i] >> b & 1)) continue;
            if (!is_loaded) load_target_packet(target, &tile, b, &packet);
            is_loaded = true;
            is_changed |= offer_triangle(target, &packet, gathered->triangle[i]);
        }
        if (is_changed) store_target_packet(target, tile, b, &packet);
    }
}

/* A work-item takes a tile whose ancestor, at step.level + 1, was left over by the stream: the
 * ancestor's triangles against the blocks of the tile, then against their rays. Levels in
 * between are skipped. nodes: those of rsh_build. */
RSH_FILLS_VECTORS
__kernel void rsh_intersect_ranges_finish(
    ray_levels shape, __global const uint* list_count, range_step given, mesh_view mesh,
    __global const float* vertices, __global const uint* indices, __global const rsh_ray* rays,
    __global const uint* skip, __global const float* bounds, __global const float* nodes,
    __global const uint* triangles, __global const uint2* ranges, __global const uint* sums,
    __global rsh_hit* hits, __global uint* occlusion, uint occlusion_bit,
    __global uint* tally RSH_FILTER_PARAMETERS RSH_BATCH_PARAMETERS)
{
    const ray_levels levels = counted_levels(shape, list_count);
    const uint me = my_element(tile_count(levels));
    if (me == tile_count(levels)) return;
    const range_step step = counted_step(given, &levels, list_count);
    const uint ancestor = ancestor_of(&levels, 2, me, step.level + 1);
    if (!is_left_over(step, sums, ancestor)) return;
    const triangle_range range = range_of_parent(step, ranges, ancestor);
    hit_list list = hit_list_in(hits, occlusion_bit, 1);
    const range_target target = {
        {mesh, vertices, indices, rays, skip RSH_GIVEN_FILTER RSH_GIVEN_BATCH},
        hits,
        occlusion,
        occlusion_bit,
        bounds,
        &list};
    const ray_tile tile = tile_at(levels, order_in(nodes), me);
    sibling_nodes blocks;
    load_siblings(&blocks, nodes + RSH_NODES_HEAD_WORDS + (ulong)RSH_GROUP_FLOATS * me);
    gathered_triangles gathered;
    gathered.count = 0;
    uint pairs = 0;
    for (uint i = range.begin; i < range.begin + range.count; ++i) {
        const uint triangle = triangle_at(step, triangles, i);
        const uint met = siblings_meeting(&blocks, bounds, triangle);
        if (met) {
            gathered.triangle[gathered.count] = triangle;
            gathered.met[gathered.count++] = (ushort)met;
            pairs += popcount(met);
        }
        if (gathered.count < RSH_GATHERED) continue;
        intersect_gathered(&target, tile, &gathered);
        gathered.count = 0;
    }
    intersect_gathered(&target, tile, &gathered);
    if (!step.is_counting) return;
    add_to_count(tally + RSH_TALLY_FINISHED, range.count);
    add_to_count(tally + RSH_TALLY_FINISHED + 2, pairs);
}
