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
#include "scene_boxes.h"
#include "tile_block.h"

#define RSH_STACK (15 * RSH_MAX_BOX_LEVELS + 1)

/* More triangles of a cluster than this are worth asking each ray first. */
#define RSH_MANY_TRIANGLES 4
/* Up to so many blocks look at a cluster's triangles on their own. */
#define RSH_FEW_BLOCKS 3
/* What going down the boxes costs besides what is met there, in clusters met. */
#define RSH_START 20.0f
/* Clusters that a ray on its own meets, in the same measure as a bundle. */
#define RSH_RAY 8.0f

typedef struct rsh_geometry_in {
    rsh_mesh mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const float* boxes;
    __global const uint* children;
    rsh_box_levels levels;
} rsh_geometry_in;

typedef struct rsh_work {
    const rsh_geometry_in* scene;
    __global const rsh_ray* rays;
    __global const float* nodes; /* of the tile */
    rsh_tile tile;
    bool is_any;
    bool is_converging; /* nodes run backwards: a hit is no limit to them */
    uint loaded;        /* blocks */
    float scene_size;   /* longest side */
    float cluster_size; /* see scene_boxes.h */
    rsh_bundles blocks;
    rsh_block block[16];
    uint node_tests, ray_tests;
} rsh_work;

/* What goes down the boxes together: some blocks of the tile, or one ray. */
typedef struct rsh_probe {
    rsh_bundle bundle;
    uint blocks;     /* bit mask */
    uint ray;        /* of the only block; 16: all its rays */
    int ray_sign[3]; /* that of all its rays per axis, or 0 */
} rsh_probe;

static uint lowest_bit(uint bits) { return 31 - clz(bits & -bits); }
static bool is_single(uint bits) { return (bits & (bits - 1)) == 0; }

static rsh_block* block_of(rsh_work* work, uint b)
{
    rsh_block* block = &work->block[b];
    if (work->loaded >> b & 1) return block;
    load_block(block, work->tile, b, work->rays);
    for (uint axis = 0; axis < 3; ++axis)
        block->bundle.slab[axis] =
            slab_of(work->nodes[16 * axis + b], work->nodes[48 + 16 * axis + b],
                    work->nodes[96 + 16 * axis + b], work->nodes[144 + 16 * axis + b]);
    work->loaded |= 1u << b;
    return block;
}

/* The block as a node; to be asked at once, before its limit changes. */
static const rsh_bundle* block_bundle(rsh_work* work, uint b)
{
    rsh_bundle* bundle = &block_of(work, b)->bundle;
    bundle->limit = lane_of(work->blocks.limit, b);
    return bundle;
}

static __global const float* group_of(const rsh_geometry_in* scene, uint level, uint group)
{
    return scene->boxes + RSH_GROUP_WORDS * (scene->levels.first_group[level] + group);
}

/* Boxes of a group that exist. */
static uint boxes_of(uint count, uint group)
{
    const uint left = count - 16 * group;
    return left < 16 ? (1u << left) - 1 : 0xffffu;
}

static void load_box(__global const float* group, uint k, float* low, float* high)
{
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = group[16 * axis + k];
        high[axis] = group[48 + 16 * axis + k];
    }
}

/* How far the probe still has to look. */
static void lower_limit(rsh_work* work, rsh_probe* probe)
{
    if (is_single(probe->blocks)) {
        const uint b = lowest_bit(probe->blocks);
        probe->bundle.limit =
            probe->ray < 16
                ? lane_of(&work->block[b].ray[probe->ray / RSH_WIDTH].tmax,
                          probe->ray % RSH_WIDTH) *
                      RSH_RAISED
                : lane_of(work->blocks.limit, b);
        return;
    }
    floatv limit[RSH_VECTORS];
    for (uint v = 0; v < RSH_VECTORS; ++v) limit[v] = work->blocks.limit[v];
    for (uint b = 0; b < 16; ++b)
        if (!(probe->blocks >> b & 1)) ((float*)limit)[b] = -1.0f;
    probe->bundle.limit = largest_lane(limit);
}

static void update_limits(rsh_work* work, rsh_probe* probe, uint changed)
{
    for (; changed; changed &= changed - 1) {
        const uint b = lowest_bit(changed);
        const float limit = block_limit(&work->block[b]);
        if (!work->is_converging || limit < 0.0f) ((float*)work->blocks.limit)[b] = limit;
    }
    lower_limit(work, probe);
}

/* Triangles of a cluster that some ray of the block meets, where that leaves fewer. */
static uint triangles_met_by_rays(rsh_work* work, const rsh_probe* probe, rsh_block* block,
                                  __global const float* cluster, const float* low,
                                  const float* high, uint triangles)
{
    work->node_tests += 16;
    uint rays = rays_meeting(block, probe->ray_sign, low, high);
    if (popcount(rays) + 2 >= popcount(triangles)) return triangles;
    uint met = 0;
    for (; rays; rays &= rays - 1) {
        const rsh_bundle ray = ray_bundle(block, lowest_bit(rays));
        work->node_tests += 16;
        met |= boxes_met(&ray, cluster, 0);
    }
    return triangles & met;
}

/* The triangles of one cluster that were needed so far. */
typedef struct rsh_cluster {
    uint number; /* its group of level 0 */
    uint fetched;
    uint triangle[16];
    rsh_corners corners[16];
} rsh_cluster;

static bool intersect_triangle(rsh_work* work, rsh_cluster* cluster, uint k, uint b)
{
    const rsh_geometry_in* scene = work->scene;
    if (!(cluster->fetched >> k & 1)) {
        cluster->triangle[k] = triangle_in((__global const uint*)scene->boxes, scene->levels,
                                           16 * cluster->number + k);
        fetch_corners(&cluster->corners[k], scene->mesh, scene->vertices, scene->indices,
                      cluster->triangle[k]);
        cluster->fetched |= 1u << k;
    }
    work->ray_tests += 16;
    return intersect_block(block_of(work, b), &cluster->corners[k], cluster->triangle[k],
                           work->is_any);
}

/* Few blocks: each looks for its own triangles. */
static uint intersect_by_block(rsh_work* work, const rsh_probe* probe, rsh_cluster* cluster,
                               uint blocks, uint triangles, const float* low, const float* high)
{
    __global const float* boxes = group_of(work->scene, 0, cluster->number);
    uint changed = 0;
    for (; blocks; blocks &= blocks - 1) {
        const uint b = lowest_bit(blocks);
        rsh_block* block = block_of(work, b);
        const rsh_bundle* bundle =
            is_single(probe->blocks) ? &probe->bundle : block_bundle(work, b);
        work->node_tests += 16;
        uint mine = boxes_met(bundle, boxes, 0) & triangles;
        if (popcount(mine) > RSH_MANY_TRIANGLES && block->is_fit && probe->ray == 16)
            mine = triangles_met_by_rays(work, probe, block, boxes, low, high, mine);
        for (; mine; mine &= mine - 1)
            if (intersect_triangle(work, cluster, lowest_bit(mine), b)) changed |= 1u << b;
    }
    return changed;
}

/* Many blocks: each triangle looks for its own. */
static uint intersect_by_triangle(rsh_work* work, const rsh_probe* probe, rsh_cluster* cluster,
                                  uint blocks, uint triangles)
{
    __global const float* boxes = group_of(work->scene, 0, cluster->number);
    uint changed = 0;
    for (; triangles; triangles &= triangles - 1) {
        const uint k = lowest_bit(triangles);
        float low[3], high[3];
        load_box(boxes, k, low, high);
        work->node_tests += 16;
        uint met = bundles_meeting(&work->blocks, &probe->bundle, low, high) & blocks;
        for (; met; met &= met - 1) {
            const uint b = lowest_bit(met);
            if (intersect_triangle(work, cluster, k, b)) changed |= 1u << b;
        }
    }
    return changed;
}

static void intersect_cluster(rsh_work* work, rsh_probe* probe, uint number, uint blocks,
                              const float* low, const float* high)
{
    rsh_cluster cluster;
    cluster.number = number;
    cluster.fetched = 0;
    uint triangles = boxes_of(work->scene->mesh.triangle_count, number);
    if (popcount(blocks) > RSH_FEW_BLOCKS) {
        work->node_tests += 16;
        triangles &= boxes_met(&probe->bundle, group_of(work->scene, 0, number), 0);
    }
    const uint changed =
        popcount(triangles) < popcount(blocks)
            ? intersect_by_triangle(work, probe, &cluster, blocks, triangles)
            : intersect_by_block(work, probe, &cluster, blocks, triangles, low, high);
    if (changed) update_limits(work, probe, changed);
}

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

/* Rows of the tile's nodes, of some of its blocks only: the others hold nothing. */
static float lowest_of(const rsh_work* work, uint row, uint blocks)
{
    float low = INFINITY;
    for (; blocks; blocks &= blocks - 1)
        low = fmin(low, work->nodes[16 * row + lowest_bit(blocks)]);
    return low;
}

static float highest_of(const rsh_work* work, uint row, uint blocks)
{
    float high = -INFINITY;
    for (; blocks; blocks &= blocks - 1)
        high = fmax(high, work->nodes[16 * row + lowest_bit(blocks)]);
    return high;
}

/* What it may cost to take the blocks through the scene together, in clusters met: their share
 * of the surface of the box that the rays fill at the scene's far end. */
static float cost_of(const rsh_work* work, uint blocks)
{
    float low[6], high[6], longest = 0.0f;
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = lowest_of(work, axis, blocks);
        high[axis] = highest_of(work, 3 + axis, blocks);
        low[3 + axis] = lowest_of(work, 6 + axis, blocks);
        high[3 + axis] = highest_of(work, 9 + axis, blocks);
        longest = fmax(longest, fmax(fabs(low[3 + axis]), fabs(high[3 + axis])));
    }
    const float t = fmin(highest_of(work, 12, blocks), work->scene_size / longest);
    float side[3];
    for (uint axis = 0; axis < 3; ++axis)
        side[axis] = fmin(high[axis] - low[axis] + t * (high[3 + axis] - low[3 + axis]),
                          work->scene_size);
    return RSH_START +
           (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]) / work->cluster_size;
}

static rsh_probe probe_of(rsh_work* work, uint blocks)
{
    rsh_probe probe;
    probe.blocks = blocks;
    probe.ray = 16;
    for (uint axis = 0; axis < 3; ++axis) {
        probe.bundle.slab[axis] =
            slab_of(lowest_of(work, axis, blocks), highest_of(work, 3 + axis, blocks),
                    lowest_of(work, 6 + axis, blocks), highest_of(work, 9 + axis, blocks));
        const int sign = probe.bundle.slab[axis].sign;
        probe.ray_sign[axis] = work->is_converging ? -sign : sign;
    }
    lower_limit(work, &probe);
    return probe;
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
