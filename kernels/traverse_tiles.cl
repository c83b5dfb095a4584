/* traverse_tiles.cl - a work-item finishes a tile of 256 rays: boxes of the scene front to
 * back, triangles and single rays last.
 *   boxes      in      of triangles, clusters, clusters of clusters (scene_boxes.h)
 *   nodes      in      blocks of the tiles (build_boxes.cl)
 *   hits       out     closest
 *   occlusion  in/out  any: a bit per ray
 * Nothing leaves the work-item but its answers; what it needs is known beforehand: a stack of
 * 15 boxes per level. Whatever a decision below costs or saves, it only leaves out tests that
 * cannot succeed.
 */
#include "tile_cluster.h"
#include "tile_probe.h"

#define RSH_STACK (15 * RSH_MAX_BOX_LEVELS + 1)

/* Clusters that a ray on its own meets, in the measure of tile_probe.h. */
#define RSH_RAY 8.0f

typedef struct rsh_stack {
    uint size;
    float near[RSH_STACK];
    uint box[RSH_STACK]; /* level * 2^28 + number */
} rsh_stack;

/* The boxes of a group that the bundle can meet, the nearest on top. */
static void push_group(rsh_stack* stack, rsh_work* work, const rsh_bundle* bundle, uint level,
                       uint group)
{
    float near[16];
    work->node_tests += 16;
    uint met = boxes_met(bundle, group_of(work->scene, level, group), near) &
               boxes_of(work->scene->levels.boxes[level], group);
    const uint bottom = stack->size;
    for (; met; met &= met - 1) {
        const uint k = lowest_bit(met);
        uint at = stack->size++;
        for (; at > bottom && stack->near[at - 1] < near[k]; --at) {
            stack->near[at] = stack->near[at - 1];
            stack->box[at] = stack->box[at - 1];
        }
        stack->near[at] = near[k];
        stack->box[at] = level << 28 | (16 * group + k);
    }
}

static void visit_box(rsh_stack* stack, rsh_work* work, rsh_probe* probe, uint level, uint box)
{
    uint blocks = probe->blocks;
    float low[3], high[3];
    load_box(group_of(work->scene, level, box / 16), box % 16, low, high);
    if (!is_single(blocks)) {
        work->node_tests += 16;
        blocks &= bundles_meeting(&work->blocks, &probe->bundle, low, high);
        if (!blocks) return;
    }
    if (level == 1) {
        intersect_cluster(work, probe, work->scene->children[box], blocks, low, high);
    } else if (is_single(blocks) && !is_single(probe->blocks)) {
        push_group(stack, work, block_bundle(work, lowest_bit(blocks)), level - 1, box);
    } else {
        push_group(stack, work, &probe->bundle, level - 1, box);
    }
}

static void traverse(rsh_work* work, rsh_probe* probe)
{
    rsh_stack stack;
    stack.size = 0;
    push_group(&stack, work, &probe->bundle, work->scene->levels.count - 1, 0);
    while (stack.size) {
        const uint top = --stack.size;
        if (stack.near[top] > probe->bundle.limit) continue;
        visit_box(&stack, work, probe, stack.box[top] >> 28, stack.box[top] & 0x0fffffffu);
    }
}

static void traverse_blocks(rsh_work* work, uint blocks)
{
    rsh_probe probe = probe_of(work, blocks);
    if (probe.bundle.limit >= 0.0f) traverse(work, &probe);
}

static void traverse_rays(rsh_work* work, uint b)
{
    rsh_block* block = block_of(work, b);
    rsh_probe probe;
    probe.blocks = 1u << b;
    for (probe.ray = 0; probe.ray < 16; ++probe.ray) {
        probe.bundle = ray_bundle(block, probe.ray);
        if (probe.bundle.limit >= 0.0f) traverse(work, &probe);
    }
}

/* Blocks that hold a ray. */
static uint begin_tile(rsh_work* work)
{
    uint active = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        work->blocks.limit[v] = load_lanes(work->nodes + 16 * 12 + RSH_WIDTH * v) * RSH_RAISED;
        active |= RSH_LANE_BITS(work->blocks.limit[v] >= (floatv)(0.0f)) << (RSH_WIDTH * v);
    }
    work->is_converging = as_uint(work->nodes[16 * 13]) != 0;
    work->loaded = work->node_tests = work->ray_tests = 0;
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

static float size_of_scene(const rsh_geometry_in* scene)
{
    __global const float* top = group_of(scene, scene->levels.count - 1, 0);
    float size = 0.0f;
    for (uint axis = 0; axis < 3; ++axis) {
        floatv low[RSH_VECTORS], high[RSH_VECTORS];
        for (uint v = 0; v < RSH_VECTORS; ++v) {
            low[v] = load_lanes(top + 16 * axis + RSH_WIDTH * v);
            high[v] = load_lanes(top + 48 + 16 * axis + RSH_WIDTH * v);
        }
        size = fmax(size, largest_lane(high) - smallest_lane(low));
    }
    return size;
}

/* Each ray of a block on its own. */
#define RSH_COST_OF_RAYS (16.0f * RSH_RAY)

static void traverse_block(rsh_work* work, uint b, float cost)
{
    if (cost >= RSH_COST_OF_RAYS && block_of(work, b)->is_fit)
        traverse_rays(work, b);
    else
        traverse_blocks(work, 1u << b);
}

/* Together, if that costs no more than one by one. */
static bool traverse_together(rsh_work* work, uint blocks, const float* cost)
{
    float apart = 0.0f;
    for (uint left = blocks; left; left &= left - 1) apart += cost[lowest_bit(left)];
    if (cost_of(work, blocks) > apart) return false;
    traverse_blocks(work, blocks);
    return true;
}

/* A tile whose rays have little in common, as at the edge between two mirrors, goes by
 * quarters, blocks or rays. */
static void traverse_tile(rsh_work* work, uint active)
{
    float cost[16];
    for (uint left = active; left; left &= left - 1)
        cost[lowest_bit(left)] =
            fmin(cost_of(work, left & -left), RSH_COST_OF_RAYS);
    if (traverse_together(work, active, cost)) return;
    for (uint quarter = 0; quarter < 4; ++quarter) {
        uint blocks = active & (0x0033u << (quarter / 2 * 8 + quarter % 2 * 2));
        if (!blocks || traverse_together(work, blocks, cost)) continue;
        for (; blocks; blocks &= blocks - 1)
            traverse_block(work, lowest_bit(blocks), cost[lowest_bit(blocks)]);
    }
}

__kernel void rsh_traverse_tiles(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_box_levels levels,
                                 __global const float* boxes, rsh_levels shape,
                                 __global const rsh_ray* rays, __global const float* nodes,
                                 __global rsh_hit* hits, __global uint* occlusion,
                                 uint occlusion_bit, uint is_counting, __global uint* counts)
{
    const uint me = get_global_id(0);
    if (me >= tile_count(shape)) return; /* launch is rounded up to whole groups */
    __global const uint* children = (__global const uint*)boxes + children_at(levels);
    const rsh_geometry_in scene = {mesh, vertices, indices, boxes, children, levels};
    rsh_work work;
    work.scene = &scene;
    work.rays = rays;
    work.nodes = nodes + 16ul * RSH_NODE_ROWS * me;
    work.tile = tile_at(shape, me);
    work.is_any = occlusion_bit != 0;
    const uint active = begin_tile(&work);
    if (active && mesh.triangle_count) {
        work.scene_size = size_of_scene(&scene);
        work.cluster_size = fmax(boxes[cluster_size_at(levels)],
                                 1e-7f * work.scene_size * work.scene_size);
        traverse_tile(&work, active);
    }
    for (uint b = 0; b < 16; ++b) {
        const bool is_loaded = work.loaded >> b & 1;
        if (!occlusion_bit && !is_loaded)
            store_misses(work.tile, b, rays, hits);
        else if (!occlusion_bit)
            store_hits(&work.block[b], work.tile, b, hits);
        else if (is_loaded)
            store_occlusion(&work.block[b], work.tile, b, occlusion, occlusion_bit);
    }
    if (!is_counting) return;
    atomic_add(counts, work.node_tests);
    atomic_add(counts + 1, work.ray_tests);
}
