/* traverse_tiles.cl - a work-item finishes a tile of 256 rays: boxes of the scene front to
 * back, triangles last. Rays go down the boxes together, as a tile, where they are worth it;
 * where few blocks of the tile meet a box, block by block; where few rays of a block do, ray by
 * ray.
 *   boxes      in      the scene's, and the triangles themselves; see bvh/layout.h
 *   nodes      in      blocks of the tiles (rays/build_boxes.cl)
 *   hits       out     closest
 *   occlusion  in/out  any: a bit per ray
 * Nothing leaves the work-item but its answers; what it needs is known beforehand: a stack of
 * 15 boxes per group on the way down. Whatever a decision below costs or saves, it only
 * leaves out tests that cannot succeed.
 */
#include "traverse/tiles/descend_packet.h"
#include "traverse/tiles/packet_cost.h"

/* So many blocks go on alone; more, where boxes that all blocks together meet were met by none
 * of them. */
#define RSH_FEW_BLOCKS 2

/* In clusters met, the measure of traverse/tiles/packet_cost.h: what going down the boxes costs besides what is
 * met there, for blocks and for a ray. */
#define RSH_START 40.0f
#define RSH_RAY 8.0f

/* Rays of a block that fill this much of the scene have no order of boxes in common. */
#define RSH_WIDE 0.1f

/* Blocks of the tile that go down the boxes together. */
typedef struct rsh_probe {
    rsh_bundle bundle;
    uint blocks; /* bit mask */
    int sign[3]; /* that of all their rays per axis, or 0 */
    uint wasted; /* visits that met no block, less those that did */
} rsh_probe;

static rsh_probe probe_of(const rsh_work* work, uint blocks, const rsh_hull* hull)
{
    rsh_probe probe = {bundle_of(hull), blocks, {0, 0, 0}, 0};
    for (uint axis = 0; axis < 3; ++axis) {
        const int sign = probe.bundle.slab[axis].sign;
        probe.sign[axis] = work->is_converging ? -sign : sign;
    }
    return probe;
}

/* How far the probe still has to look. */
static void lower_limit(const rsh_work* work, rsh_probe* probe)
{
    floatv limit[RSH_VECTORS];
    for (uint v = 0; v < RSH_VECTORS; ++v) limit[v] = work->blocks.limit[v];
    for (uint b = 0; b < 16; ++b)
        if (!(probe->blocks >> b & 1)) ((float*)limit)[b] = -1.0f;
    probe->bundle.limit = largest_lane(limit);
}

static void visit_box(rsh_work* work, rsh_probe* probe, const rsh_box* box)
{
    work->node_tests += 16;
    uint blocks =
        bundles_meeting(&work->blocks, &probe->bundle, box->low, box->high) & probe->blocks;
    const uint few = RSH_FEW_BLOCKS + probe->wasted;
    probe->wasted = blocks ? probe->wasted - (probe->wasted > 0) : probe->wasted + 1;
    if (!blocks) return;
    if (popcount(blocks) > few && !is_cluster(box->below)) {
        push_boxes_met(work, &probe->bundle, box->below);
        return;
    }
    if (popcount(blocks) > few)
        intersect_cluster_by_blocks(work, &probe->bundle, probe->sign, box, blocks);
    else
        for (; blocks; blocks &= blocks - 1) {
            rsh_block_probe block = {lowest_bit(blocks), probe->sign, 0};
            const uint bottom = work->stack_size;
            visit_box_by_block(work, &block, box);
            traverse_block(work, &block, bottom);
        }
    lower_limit(work, probe);
}

static void traverse(rsh_work* work, uint blocks, const rsh_hull* hull)
{
    rsh_probe probe = probe_of(work, blocks, hull);
    lower_limit(work, &probe);
    push_boxes_met(work, &probe.bundle, work->scene->top);
    if (is_single(blocks)) {
        rsh_block_probe block = {lowest_bit(blocks), probe.sign, 0};
        traverse_block(work, &block, 0);
        return;
    }
    while (work->stack_size) {
        const ulong top = work->stack[--work->stack_size];
        if (near_of(top) > probe.bundle.limit) continue;
        const rsh_box box = load_box(work, name_of(top));
        visit_box(work, &probe, &box);
    }
}

static bool is_wide(const rsh_work* work, float cost)
{
    return cost >= RSH_WIDE * work->scene->clusters;
}

/* Together, if that costs no more than block by block. */
static bool traverse_together(rsh_work* work, uint blocks, const float* cost)
{
    const rsh_hull hull = hull_of(work, blocks);
    float apart = 0.0f, together = RSH_START + cost_of(work, &hull);
    for (uint left = blocks; left; left &= left - 1) {
        const float alone = cost[lowest_bit(left)];
        apart += is_wide(work, alone) ? 16.0f * RSH_RAY : RSH_START + alone;
        together += alone; /* each still has its own to do at the clusters */
    }
    if (together > apart) return false;
    traverse(work, blocks, &hull);
    return true;
}

static void traverse_apart(rsh_work* work, uint blocks, const float* cost)
{
    for (; blocks; blocks &= blocks - 1) {
        const uint b = lowest_bit(blocks);
        if (is_wide(work, cost[b]) && block_of(work, b)->is_fit) {
            traverse_rays(work, b);
        } else {
            const rsh_hull hull = hull_of(work, 1u << b);
            traverse(work, 1u << b, &hull);
        }
    }
}

/* A tile whose rays have little in common, as at the edge between two mirrors, goes by
 * quarters, blocks or rays. */
static void traverse_tile(rsh_work* work, uint active)
{
    float cost[16];
    costs_of_blocks(work, cost);
    if (traverse_together(work, active, cost)) return;
    for (uint quarter = 0; quarter < 4; ++quarter) {
        const uint blocks = active & (0x0033u << (quarter / 2 * 8 + quarter % 2 * 2));
        if (blocks && !traverse_together(work, blocks, cost))
            traverse_apart(work, blocks, cost);
    }
}

/* Returns the blocks that hold a ray. */
static uint begin_tile(rsh_work* work)
{
    uint active = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        work->blocks.limit[v] = load_lanes(work->nodes + 16 * 12 + RSH_WIDTH * v) * RSH_RAISED;
        active |= RSH_LANE_BITS(work->blocks.limit[v] >= (floatv)(0.0f)) << (RSH_WIDTH * v);
    }
    work->is_converging = as_uint(work->nodes[16 * 13]) != 0;
    work->loaded = work->node_tests = work->ray_tests = work->stack_size = 0;
    if (!active) return 0;
    for (uint axis = 0; axis < 3; ++axis)
        for (uint v = 0; v < RSH_VECTORS; ++v) {
            floatv row[4];
            for (uint f = 0; f < 4; ++f)
                row[f] = load_lanes(work->nodes + 16 * (3 * f + axis) + RSH_WIDTH * v);
            set_bundles_axis(&work->blocks, axis, v, row[0], row[1], row[2], row[3]);
        }
    return active;
}

static void measure_scene(rsh_work* work)
{
    rsh_boxes top;
    float side[3];
    load_boxes(group_of(work, work->scene->top), &top);
    for (uint axis = 0; axis < 3; ++axis)
        side[axis] = largest_lane(top.high[axis]) - smallest_lane(top.low[axis]);
    work->scene_size = fmax(side[0], fmax(side[1], side[2]));
    const float surface = side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
    work->cluster_size = surface / work->scene->clusters;
}

static void store_answers(const rsh_work* work, __global rsh_hit* hits,
                          __global uint* occlusion, uint occlusion_bit)
{
    for (uint b = 0; b < 16; ++b) {
        const bool is_loaded = work->loaded >> b & 1;
        if (!work->is_any && !is_loaded)
            store_misses(work->tile, b, work->rays, hits);
        else if (!work->is_any)
            store_hits(&work->block[b], work->tile, b, hits);
        else if (is_loaded)
            store_occlusion(&work->block[b], work->tile, b, occlusion, occlusion_bit);
    }
}

__kernel void rsh_traverse_tiles(rsh_scene_shape scene_shape, __global const float* boxes,
                                 rsh_levels shape, __global const rsh_ray* rays,
                                 __global const float* nodes, __global rsh_hit* hits,
                                 __global uint* occlusion, uint occlusion_bit, uint is_counting,
                                 __global uint* counts)
{
    const uint me = get_global_id(0);
    if (me >= tile_count(shape)) return; /* launch is rounded up to whole groups */
    rsh_scene_in scene;
    scene.shape = scene_shape;
    scene.boxes = boxes;
    scene.top = bounds_head_of(boxes)->groups.end - 1;
    scene.clusters = (float)((scene_shape.triangles + 15) / 16);
    rsh_work work;
    work.scene = &scene;
    work.rays = rays;
    work.nodes = nodes + 16ul * RSH_NODE_ROWS * me;
    work.tile = tile_at(shape, (__global const uint*)nodes, me);
    work.is_any = occlusion_bit != 0;
    const uint active = begin_tile(&work);
    if (active && scene_shape.triangles) {
        measure_scene(&work);
        traverse_tile(&work, active);
    }
    store_answers(&work, hits, occlusion, occlusion_bit);
    if (!is_counting) return;
    atomic_add(counts, work.node_tests);
    atomic_add(counts + 1, work.ray_tests);
}
