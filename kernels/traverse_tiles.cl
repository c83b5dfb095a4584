/* traverse_tiles.cl - a work-item finishes a tile of 256 rays: boxes front to back, its 16
 * blocks of rays last.
 *   groups     in      boxes of triangles, clusters, clusters of clusters (bound_boxes.cl)
 *   nodes      in      blocks of the tile (build_boxes.cl)
 *   hits       out     closest
 *   occlusion  in/out  any: a bit per ray
 * No stream leaves the work-item; what it needs is known beforehand: a stack of 15 boxes per
 * level.
 */
#include "box.h"
#include "intersect.h"
#include "tile.h"

#define RSH_NODE_ROWS 14
#define RSH_STACK (15 * RSH_MAX_BOX_LEVELS + 1)

/* 16 rays; tmax is lowered to the closest hit so far. */
typedef struct rsh_block {
    rsh_sheared ray[RSH_VECTORS];
    floatv inverse[3][RSH_VECTORS]; /* of the direction */
    intv is_negative[3][RSH_VECTORS];
    floatv u[RSH_VECTORS], v[RSH_VECTORS];
    uintv primitive[RSH_VECTORS];
    float pad;     /* of the origins; negative: a direction too small to divide by */
    uint axis;     /* kz of all rays; 3: they differ */
    rsh_bundle bundle;
} rsh_block;

typedef struct rsh_scene_in {
    rsh_mesh mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const float* groups;
} rsh_scene_in;

typedef struct rsh_work {
    rsh_tile tile;
    __global const rsh_ray* rays;
    __global const float* nodes;
    uint any;
    uint fixed; /* limits of nodes do not shrink: reversed rays */
    uint loaded;
    int sign[3];     /* of the blocks' directions, where all have one */
    int ray_sign[3]; /* of the rays' */
    rsh_bundle bundle;
    rsh_bundles blocks;
    rsh_block block[16];
    uint stats[8];
} rsh_work;

static uint lowest_bit(uint bits) { return 31 - clz(bits & -bits); }

#if RSH_WIDTH == 16
#define RSH_LARGEST(name, OP)                                        \
    static float name(const floatv* v)                               \
    {                                                                \
        const float8 a = OP(v[0].lo, v[0].hi);                       \
        const float4 b = OP(a.lo, a.hi);                             \
        const float2 c = OP(b.lo, b.hi);                             \
        return OP(c.x, c.y);                                         \
    }
#else
#define RSH_LARGEST(name, OP)                                                          \
    static float name(const floatv* v)                                                 \
    {                                                                                  \
        float lane[16];                                                                \
        for (uint i = 0; i < RSH_VECTORS; ++i) store_lanes(v[i], lane + RSH_WIDTH * i); \
        float all = lane[0];                                                           \
        for (uint i = 1; i < 16; ++i) all = OP(all, lane[i]);                          \
        return all;                                                                    \
    }
#endif
RSH_LARGEST(largest_lane, fmax)
RSH_LARGEST(smallest_lane, fmin)

/* kz, where all rays have the same. */
static uint common_axis(const rsh_sheared* ray)
{
    uint is_x = 0, is_y = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        is_x |= RSH_LANE_BITS(ray[v].kz_is_x) << (RSH_WIDTH * v);
        is_y |= RSH_LANE_BITS(ray[v].kz_is_y) << (RSH_WIDTH * v);
    }
    return is_x == 0xffff ? 0 : is_y == 0xffff ? 1 : is_x == 0 && is_y == 0 ? 2 : 3;
}

static void load_block(rsh_work* work, uint b)
{
    float lanes[8][16];
    rsh_block* block = &work->block[b];
    float largest = 0.0f;
    bool is_tiny = false;
    uint other = 0;
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(work->tile, b, k);
        const rsh_ray ray = work->rays[i == RSH_NO_RAY ? 0 : i];
        const bool is_used = i != RSH_NO_RAY && is_active(ray);
        float row[8];
        vstore8((float8)(ray.origin_tmin, ray.direction_tmax), 0, row);
        for (uint f = 0; f < 8; ++f) lanes[f][k] = row[f];
        if (!is_used) {
            lanes[7][k] = -1.0f;
            continue;
        }
        for (uint axis = 0; axis < 3; ++axis) {
            largest = fmax(largest, fabs(row[axis]));
            is_tiny |= row[4 + axis] != 0.0f && fabs(row[4 + axis]) < 0x1p-120f;
        }
        other = k;
    }
    for (uint k = 0; k < 16; ++k)
        if (lanes[7][k] < 0.0f)
            for (uint f = 4; f < 7; ++f) lanes[f][k] = lanes[f][other];
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const uint at = RSH_WIDTH * v;
        block->ray[v] = shear_rays(load_lanes(lanes[0] + at), load_lanes(lanes[1] + at),
                                   load_lanes(lanes[2] + at), load_lanes(lanes[4] + at),
                                   load_lanes(lanes[5] + at), load_lanes(lanes[6] + at),
                                   load_lanes(lanes[3] + at), load_lanes(lanes[7] + at));
        block->primitive[v] = (uintv)(RSH_NO_HIT);
        block->u[v] = block->v[v] = (floatv)(0.0f);
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv d = load_lanes(lanes[4 + axis] + at);
            block->is_negative[axis][v] = d < (floatv)(0.0f);
            block->inverse[axis][v] = (floatv)(1.0f) / (d + (floatv)(0.0f));
        }
    }
    block->pad = is_tiny ? -1.0f : pad_of(largest);
    block->axis = common_axis(block->ray);
    for (uint axis = 0; axis < 3; ++axis)
        block->bundle.slab[axis] =
            slab_of(work->nodes[16 * axis + b], work->nodes[48 + 16 * axis + b],
                    work->nodes[96 + 16 * axis + b], work->nodes[144 + 16 * axis + b]);
    work->loaded |= 1u << b;
}

/* Which rays of the block meet the box. */
static uint rays_meeting(const rsh_block* block, const int* sign, const float* box_low,
                         const float* box_high)
{
    uint met = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const rsh_sheared r = block->ray[v];
        const floatv origin[3] = {r.origin_x, r.origin_y, r.origin_z};
        floatv from = (floatv)(0.0f), to = r.tmax;
        for (uint axis = 0; axis < 3; ++axis) {
            const float low = box_low[axis] - block->pad, high = box_high[axis] + block->pad;
            const floatv inverse = block->inverse[axis][v];
            if (sign[axis]) {
                const float near = sign[axis] > 0 ? low : high;
                const float far = sign[axis] > 0 ? high : low;
                from = greater((near - origin[axis]) * inverse, from);
                to = lesser((far - origin[axis]) * inverse, to);
            } else {
                const intv is_negative = block->is_negative[axis][v];
                const floatv near = select((floatv)(low), (floatv)(high), is_negative);
                const floatv far = select((floatv)(high), (floatv)(low), is_negative);
                from = greater((near - origin[axis]) * inverse, from);
                to = lesser((far - origin[axis]) * inverse, to);
            }
        }
        met |= RSH_LANE_BITS(from <= to * RSH_RAISED) << (RSH_WIDTH * v);
    }
    return met;
}

static rsh_bundle ray_bundle(const rsh_block* block, uint k)
{
    rsh_bundle bundle;
    const float* o[3] = {(const float*)&block->ray[k / RSH_WIDTH].origin_x, (const float*)&block->ray[k / RSH_WIDTH].origin_y, (const float*)&block->ray[k / RSH_WIDTH].origin_z};
    for (uint axis = 0; axis < 3; ++axis) {
        const float inverse = ((const float*)block->inverse[axis])[k];
        const float origin = o[axis][k % RSH_WIDTH];
        const bool neg = inverse < 0.0f;
        bundle.slab[axis] = (rsh_slab){neg ? origin - block->pad : origin + block->pad, inverse, neg ? origin + block->pad : origin - block->pad,
                                       inverse * RSH_RAISED, neg ? -1 : 1};
    }
    bundle.limit = ((const float*)&block->ray[k / RSH_WIDTH].tmax)[k % RSH_WIDTH] * RSH_RAISED;
    return bundle;
}

static bool begin_tile(rsh_work* work, __global const float* nodes)
{
    rsh_bundles* blocks = &work->blocks;
    floatv row[4][RSH_VECTORS];
    work->nodes = nodes;
    for (uint v = 0; v < RSH_VECTORS; ++v)
        blocks->limit[v] = load_lanes(nodes + 16 * 12 + RSH_WIDTH * v) * RSH_RAISED;
    work->bundle.limit = largest_lane(blocks->limit);
    work->loaded = 0;
    work->fixed = as_uint(nodes[16 * 13]);
    if (!(work->bundle.limit >= 0.0f)) return false;
    for (uint axis = 0; axis < 3; ++axis) {
        for (uint v = 0; v < RSH_VECTORS; ++v) {
            for (uint f = 0; f < 4; ++f)
                row[f][v] = load_lanes(nodes + 16 * (3 * f + axis) + RSH_WIDTH * v);
            set_bundles_axis(blocks, axis, v, row[0][v], row[1][v], row[2][v], row[3][v]);
        }
        work->bundle.slab[axis] = slab_of(smallest_lane(row[0]), largest_lane(row[1]),
                                          smallest_lane(row[2]), largest_lane(row[3]));
        work->sign[axis] = work->bundle.slab[axis].sign;
        work->ray_sign[axis] = work->fixed ? -work->sign[axis] : work->sign[axis];
    }
    return true;
}

static void set_limit(rsh_work* work, uint b)
{
    rsh_block* block = &work->block[b];
    floatv tmax[RSH_VECTORS];
    for (uint v = 0; v < RSH_VECTORS; ++v) tmax[v] = block->ray[v].tmax;
    const float limit = largest_lane(tmax) * RSH_RAISED;
    if (work->fixed && limit >= 0.0f) return;
    ((float*)work->blocks.limit)[b] = limit;
}

/* The corners of a cluster's triangles, fetched when first needed. */
typedef struct rsh_corners {
    uint loaded;
    float corner[16][9];
    float scale[16];
} rsh_corners;

static void load_corners_of(rsh_corners* corners, const rsh_scene_in* scene, uint cluster, uint k)
{
    rsh_triangle p;
    load_triangle(scene->mesh, scene->vertices, scene->indices, 16 * cluster + k, &p);
    float* c = corners->corner[k];
    c[0] = p.v0.x;
    c[1] = p.v0.y;
    c[2] = p.v0.z;
    c[3] = p.v1.x;
    c[4] = p.v1.y;
    c[5] = p.v1.z;
    c[6] = p.v2.x;
    c[7] = p.v2.y;
    c[8] = p.v2.z;
    float size = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        size = fmax(size, fmax(fabs(c[3 + axis] - c[axis]), fabs(c[6 + axis] - c[axis])));
    const int exponent = as_int(size) & 0x7f800000;
    corners->scale[k] = size >= 0x1p-20f && size <= 0x1p20f ? 1.0f : as_float(0x7f000000 - min(exponent, 0x7e800000));
    corners->loaded |= 1u << k;
}

#define SEE_ALONG(ox, oy, oz, i, x, y, z, px, py, pz)     \
    do {                                                  \
        pz = (floatv)(c[3 * i + z]) - oz;                 \
        px = ((floatv)(c[3 * i + x]) - ox) - r.slope_x * pz;        \
        py = ((floatv)(c[3 * i + y]) - oy) - r.slope_y * pz;        \
    } while (0)

static rsh_seen see_along(rsh_sheared r, floatv ox, floatv oy, floatv oz, const float* c, uint x,
                          uint y, uint z)
{
    rsh_seen s;
    SEE_ALONG(ox, oy, oz, 0, x, y, z, s.ax, s.ay, s.az);
    SEE_ALONG(ox, oy, oz, 1, x, y, z, s.bx, s.by, s.bz);
    SEE_ALONG(ox, oy, oz, 2, x, y, z, s.cx, s.cy, s.cz);
    return s;
}

static rsh_seen see_triangle(rsh_sheared r, uint axis, const float* c)
{
    if (axis == 0) return see_along(r, r.origin_y, r.origin_z, r.origin_x, c, 1, 2, 0);
    if (axis == 1) return see_along(r, r.origin_z, r.origin_x, r.origin_y, c, 2, 0, 1);
    if (axis == 2) return see_along(r, r.origin_x, r.origin_y, r.origin_z, c, 0, 1, 2);
    floatv corner[9];
    for (uint i = 0; i < 9; ++i) corner[i] = (floatv)(c[i]);
    return see_corners(r, corner);
}

/* True if a ray of the block has a closer hit now. */
static bool intersect_block(rsh_work* work, uint b, rsh_corners* corners,
                            const rsh_scene_in* scene, uint cluster, uint k)
{
    if (!(corners->loaded >> k & 1)) load_corners_of(corners, scene, cluster, k);
    work->stats[3]++;
    const uint triangle = 16 * cluster + k;
    rsh_block* block = &work->block[b];
    bool changed = false;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        rsh_seen seen = see_triangle(block->ray[v], block->axis, corners->corner[k]);
        if (corners->scale[k] != 1.0f) scale_across(&seen, (floatv)(corners->scale[k]));
        const rsh_hits hits = cut(block->ray[v], seen);
        const intv is_better =
            hits.is_hit & ((hits.t < block->ray[v].tmax) |
                           ((uintv)(triangle) < block->primitive[v]));
        if (!any_lane(is_better)) continue;
        changed = true;
        block->ray[v].tmax =
            select(block->ray[v].tmax, work->any ? (floatv)(-1.0f) : hits.t, is_better);
        block->u[v] = select(block->u[v], hits.u, is_better);
        block->v[v] = select(block->v[v], hits.v, is_better);
        block->primitive[v] = select(block->primitive[v], (uintv)(triangle), as_uintv(is_better));
    }
    return changed;
}

#ifndef KMIN
#define KMIN 4
#endif
#ifndef BMIN
#define BMIN 3
#endif
static void intersect_cluster(rsh_work* work, const rsh_scene_in* scene, uint cluster, uint met,
                              const float* low, const float* high)
{
    __global const float* group = scene->groups + 96ul * cluster;
    const uint left = scene->mesh.triangle_count - 16 * cluster;
    const uint valid = left < 16 ? (1u << left) - 1 : 0xffffu;
    uint changed = 0;
    rsh_corners corners;
    corners.loaded = 0;
    uint triangles = valid;
    if (popcount(met) > BMIN) triangles &= boxes_met(&work->bundle, group, 0);
    if (popcount(triangles) < popcount(met)) {
        while (triangles) {
            const uint k = lowest_bit(triangles);
            triangles &= triangles - 1;
            float tlow[3], thigh[3];
            for (uint axis = 0; axis < 3; ++axis) {
                tlow[axis] = group[16 * axis + k];
                thigh[axis] = group[48 + 16 * axis + k];
            }
            work->stats[2]++;
            uint blocks = bundles_meeting(&work->blocks, work->sign, tlow, thigh) & met;
            while (blocks) {
                const uint b = lowest_bit(blocks);
                blocks &= blocks - 1;
                if (!(work->loaded >> b & 1)) load_block(work, b);
                if (intersect_block(work, b, &corners, scene, cluster, k)) changed |= 1u << b;
            }
        }
    } else
        while (met) {
            const uint b = lowest_bit(met);
            met &= met - 1;
            if (!(work->loaded >> b & 1)) load_block(work, b);
            rsh_block* block = &work->block[b];
            block->bundle.limit = ((const float*)work->blocks.limit)[b];
            work->stats[4]++;
            uint mine = boxes_met(&block->bundle, group, 0) & triangles;
            if (popcount(mine) > KMIN && block->pad >= 0.0f) {
                uint rays = rays_meeting(block, work->ray_sign, low, high);
                work->stats[5]++;
                if (popcount(rays) < popcount(mine) - 2) {
                    uint some = 0;
                    while (rays) {
                        const uint k = lowest_bit(rays);
                        rays &= rays - 1;
                        const rsh_bundle bundle = ray_bundle(block, k);
                        some |= boxes_met(&bundle, group, 0);
                        work->stats[6]++;
                    }
                    mine &= some;
                }
            }
            while (mine) {
                const uint k = lowest_bit(mine);
                mine &= mine - 1;
                if (intersect_block(work, b, &corners, scene, cluster, k)) changed |= 1u << b;
            }
        }
    if (!changed) return;
    while (changed) {
        const uint b = lowest_bit(changed);
        changed &= changed - 1;
        set_limit(work, b);
    }
    work->bundle.limit = largest_lane(work->blocks.limit);
}

typedef struct rsh_stack {
    uint size;
    float near[RSH_STACK];
    uint box[RSH_STACK]; /* level * 2^28 + number */
} rsh_stack;

/* The boxes of a group that the tile can meet, the nearest on top. */
static void push_group(rsh_stack* stack, rsh_work* work, const rsh_bundle* bundle,
                       const rsh_box_levels* levels, __global const float* groups, uint level,
                       uint group)
{
    float near[16];
    uint met = boxes_met(bundle, groups + 96ul * (levels->first_group[level] + group), near);
    work->stats[0]++;
    const uint left = levels->boxes[level] - 16 * group;
    if (left < 16) met &= (1u << left) - 1;
    const uint bottom = stack->size;
    while (met) {
        const uint k = lowest_bit(met);
        met &= met - 1;
        uint at = stack->size++;
        for (; at > bottom && stack->near[at - 1] < near[k]; --at) {
            stack->near[at] = stack->near[at - 1];
            stack->box[at] = stack->box[at - 1];
        }
        stack->near[at] = near[k];
        stack->box[at] = level << 28 | (16 * group + k);
    }
}

static void traverse_tile(rsh_work* work, const rsh_scene_in* scene, const rsh_box_levels* levels)
{
    rsh_stack stack;
    stack.size = 0;
    push_group(&stack, work, &work->bundle, levels, scene->groups, levels->count - 1, 0);
    while (stack.size) {
        const uint top = --stack.size;
        if (stack.near[top] > work->bundle.limit) continue;
        const uint level = stack.box[top] >> 28, box = stack.box[top] & 0x0fffffffu;
        __global const float* group =
            scene->groups + 96ul * (levels->first_group[level] + box / 16) + (box & 15);
        float low[3], high[3];
        for (uint axis = 0; axis < 3; ++axis) {
            low[axis] = group[16 * axis];
            high[axis] = group[48 + 16 * axis];
        }
        work->stats[1]++;
        const uint met = bundles_meeting(&work->blocks, work->sign, low, high);
        if (!met) continue;
        if (level == 1) {
            intersect_cluster(work, scene, box, met, low, high);
            continue;
        }
        const rsh_bundle* bundle = &work->bundle;
        if (!(met & (met - 1))) {
            const uint b = lowest_bit(met);
            if (!(work->loaded >> b & 1)) load_block(work, b);
            work->block[b].bundle.limit = ((const float*)work->blocks.limit)[b];
            bundle = &work->block[b].bundle;
        }
        push_group(&stack, work, bundle, levels, scene->groups, level - 1, box);
    }
}

static void store_block(rsh_work* work, uint b, __global rsh_hit* hits, __global uint* occlusion,
                        uint occlusion_bit)
{
    float t[16], u[16], v[16];
    uint primitive[16];
    const bool is_loaded = work->loaded >> b & 1;
    if (is_loaded)
        for (uint i = 0; i < RSH_VECTORS; ++i) {
            store_lanes(work->block[b].ray[i].tmax, t + RSH_WIDTH * i);
            store_lanes(work->block[b].u[i], u + RSH_WIDTH * i);
            store_lanes(work->block[b].v[i], v + RSH_WIDTH * i);
            store_lanes(work->block[b].primitive[i], primitive + RSH_WIDTH * i);
        }
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(work->tile, b, k);
        if (i == RSH_NO_RAY) continue;
        const bool is_hit = is_loaded && primitive[k] != RSH_NO_HIT;
        if (occlusion_bit) {
            if (is_hit) occlusion[i] |= occlusion_bit;
        } else if (is_hit)
            hits[i] = (rsh_hit){t[k], u[k], v[k], primitive[k]};
        else
            hits[i] = (rsh_hit){work->rays[i].direction_tmax.w, 0.0f, 0.0f, RSH_NO_HIT};
    }
}

__kernel void rsh_traverse_tiles(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_box_levels box_shape,
                                 __global const float* groups, rsh_levels shape,
                                 __global const rsh_ray* rays, __global const float* nodes,
                                 __global rsh_hit* hits, __global uint* occlusion,
                                 uint occlusion_bit, uint is_counting, __global uint* counts)
{
    const uint me = get_global_id(0);
    if (me >= tile_count(shape)) return; /* launch is rounded up to whole groups */
    const rsh_box_levels levels = box_shape;
    rsh_scene_in scene = {mesh, vertices, indices, groups};
    rsh_work work;
    work.tile = tile_at(shape, me);
    work.rays = rays;
    work.any = occlusion_bit != 0;
    for (int i = 0; i < 8; ++i) work.stats[i] = 0;
    if (begin_tile(&work, nodes + 16ul * RSH_NODE_ROWS * me) && mesh.triangle_count)
        traverse_tile(&work, &scene, &levels);
    for (uint b = 0; b < 16; ++b) store_block(&work, b, hits, occlusion, occlusion_bit);
    if (!is_counting) return;
    uint node_tests = 0;
    for (int i = 0; i < 8; ++i)
        if (i != 3) node_tests += work.stats[i];
    atomic_add(counts, 16 * node_tests);
    atomic_add(counts + 1, 16 * work.stats[3]);
}
