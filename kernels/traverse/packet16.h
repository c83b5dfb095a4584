/* packet16.h - the sixteen rays of a block as a packet on its way through the scene: what they
 * have hit so far, which of them meet a box or a triangle, and how their hits are stored. */
#ifndef RSH_TRAVERSE_PACKET16_H
#define RSH_TRAVERSE_PACKET16_H

#include "mesh/leaving.h"
#include "rays/box_node.h"
#include "traverse/hit_list.h"
#include "traverse/hit_rows.h"
#include "traverse/leaf_triangle.h"

typedef struct ray_packet {
    sheared_rays ray[RSH_VECTORS];         /* tmax: of the closest hit so far; -1: retired */
    floatv inverse[3][RSH_VECTORS];        /* of the direction */
    intv is_negative[3][RSH_VECTORS];      /* the direction */
    floatv u[RSH_VECTORS], v[RSH_VECTORS]; /* of the closest hit */
    uintv primitive[RSH_VECTORS];
    floatv given_tmax[RSH_VECTORS];
    interval_packet intervals; /* of all rays */
    float pad;                 /* of the origins, as in rays/box_node.h */
    uint axis;                 /* kz of all rays; 3: they differ */
    bool is_fit; /* for rays_meeting and single_ray_of: no direction too small to divide by */
    const triangles_left* left; /* 0: the rays have left none */
#if RSH_FILTER
    const hit_filter* filter;
#endif
    uintv skip[RSH_VECTORS];        /* if there is `left`: the triangles that they left */
    floatv doubtful_t[RSH_VECTORS]; /* no hit behind it is doubtful, as in mesh/leaving.h */
    const ray_tile* tile;           /* whose block b it is */
    uint b;
#if RSH_ALL_HITS
    uintv count[RSH_VECTORS]; /* hits so far */
    hit_rows* rows;           /* of each vector; 0: all hits are records */
    hit_list* list;           /* the records */
#endif
} ray_packet;

/* kz of the active rays (see sheared_rays), 0 to 2; 3: they differ. */
static uint common_axis(const ray_packet* packet, uint active)
{
    uint is_x = 0, is_y = 0;
    for_each_vector(v) {
        is_x |= RSH_LANE_BITS(packet->ray[v].kz_is_x) << (RSH_WIDTH * v);
        is_y |= RSH_LANE_BITS(packet->ray[v].kz_is_y) << (RSH_WIDTH * v);
    }
    if ((is_x & active) == active) return 0;
    if ((is_y & active) == active) return 1;
    return ((is_x | is_y) & active) == 0 ? 2 : 3;
}

static void load_skip(ray_packet* packet, ray_tile tile, uint b, const triangles_left* left)
{
#if RSH_WIDTH > 1 && !RSH_BATCHES
    __global const uint* skip = left->skip;
    if (is_whole(tile, b)) {
        take_uints_apart(
            (uint16)(vload4(0, skip + ray_of(tile, b, 0)), vload4(0, skip + ray_of(tile, b, 4)),
                     vload4(0, skip + ray_of(tile, b, 8)),
                     vload4(0, skip + ray_of(tile, b, 12))),
            packet->skip);
        return;
    }
#endif
    uint lane[16];
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(tile, b, k);
        lane[k] = i == RSH_NO_RAY ? RSH_NO_HIT : triangle_left_by(left, i);
    }
    for_each_vector(v) packet->skip[v] = load_lanes(lane + RSH_WIDTH * v);
}

/* tile, left: live as long as the packet. extent: no triangle is larger. */
static void load_packet(ray_packet* packet, const ray_tile* tile, uint b,
                        const triangles_left* left, float extent)
{
    packet->tile = tile;
    packet->b = b;
    packet->left = left->skip ? left : 0;
#if RSH_FILTER
    packet->filter = &left->filter;
#endif
    if (packet->left) load_skip(packet, *tile, b, left);
    ray_block given;
    load_block(*tile, b, left->rays, &given);
    floatv reach[RSH_VECTORS];
    uint tiny = 0;
    for_each_vector(v) {
        const intv is_active = given.is_active[v];
        packet->given_tmax[v] = given.row[RSH_TMAX][v];
        packet->ray[v] = shear_rays(
            given.row[0][v], given.row[1][v], given.row[2][v], given.row[RSH_DIRECTION][v],
            given.row[RSH_DIRECTION + 1][v], given.row[RSH_DIRECTION + 2][v],
            given.row[RSH_TMIN][v], select((floatv)(-1.0f), given.row[RSH_TMAX][v], is_active));
        packet->primitive[v] = (uintv)(RSH_NO_HIT);
        packet->u[v] = packet->v[v] = reach[v] = (floatv)(0.0f);
#if RSH_ALL_HITS
        packet->count[v] = (uintv)(0u);
#endif
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv d = given.row[RSH_DIRECTION + axis][v] + (floatv)(0.0f); /* no -0 */
            packet->is_negative[axis][v] = d < (floatv)(0.0f);
            packet->inverse[axis][v] = (floatv)(1.0f) / d;
            const intv is_tiny =
                is_active & (d != (floatv)(0.0f)) & (fabs(d) < (floatv)(0x1p-120f));
            tiny |= RSH_LANE_BITS(is_tiny);
            reach[v] =
                greater(select((floatv)(0.0f), fabs(given.row[axis][v]), is_active), reach[v]);
        }
    }
    for (uint v = 0; v < RSH_VECTORS && packet->left; ++v)
        packet->doubtful_t[v] =
            (floatv)(RSH_DOUBTFUL_DEPTH * extent) * fabs(packet->ray[v].inverse_z);
    packet->pad = pad_of(largest_lane(reach));
    packet->axis = common_axis(packet, active_lanes(&given));
    packet->is_fit = tiny == 0;
}

/* tmax of the farthest ray, raised as in rays/box_node.h; negative: no ray is left. */
static float packet_limit(const ray_packet* packet)
{
    floatv tmax[RSH_VECTORS];
    for_each_vector(v) tmax[v] = packet->ray[v].tmax;
    return largest_lane(tmax) * RSH_RAISED;
}

/* Which rays meet the box, a bit each: the slab test of rays/box_node.h, where a node is one
 * ray. sign: that of all directions per axis, or 0 where they differ. */
static uint rays_meeting(const ray_packet* packet, const int* sign, const float* box_low,
                         const float* box_high)
{
    uint met = 0;
    for_each_vector(v) {
        const sheared_rays r = packet->ray[v];
        const floatv origin[3] = {r.origin_x, r.origin_y, r.origin_z};
        floatv from = (floatv)(0.0f), to = r.tmax;
        for (uint axis = 0; axis < 3; ++axis) {
            const float low = box_low[axis] - packet->pad, high = box_high[axis] + packet->pad;
            const floatv inverse = packet->inverse[axis][v];
            floatv near = (floatv)(sign[axis] < 0 ? high : low);
            floatv far = (floatv)(sign[axis] < 0 ? low : high);
            if (!sign[axis]) {
                near = select(near, (floatv)(high), packet->is_negative[axis][v]);
                far = select(far, (floatv)(low), packet->is_negative[axis][v]);
            }
            from = greater((near - origin[axis]) * inverse, from);
            to = lesser((far - origin[axis]) * inverse, to);
        }
        met |= RSH_LANE_BITS(from <= to * RSH_RAISED) << (RSH_WIDTH * v);
    }
    return met;
}

static float lane_of(const floatv* v, uint k) { return ((const float*)v)[k]; }

/* to_ray_space of mesh/intersect.h, where all rays share kz: nothing to select. */
#define RSH_TO_RAY_SPACE(axis_x, axis_y, axis_z, ox, oy, oz)              \
    do {                                                                  \
        s.az = (floatv)(at[16 * (axis_z)]) - oz;                          \
        s.bz = (floatv)(at[16 * (3 + axis_z)]) - oz;                      \
        s.cz = (floatv)(at[16 * (6 + axis_z)]) - oz;                      \
        s.ax = ((floatv)(at[16 * (axis_x)]) - ox) - r.slope_x * s.az;     \
        s.bx = ((floatv)(at[16 * (3 + axis_x)]) - ox) - r.slope_x * s.bz; \
        s.cx = ((floatv)(at[16 * (6 + axis_x)]) - ox) - r.slope_x * s.cz; \
        s.ay = ((floatv)(at[16 * (axis_y)]) - oy) - r.slope_y * s.az;     \
        s.by = ((floatv)(at[16 * (3 + axis_y)]) - oy) - r.slope_y * s.bz; \
        s.cy = ((floatv)(at[16 * (6 + axis_y)]) - oy) - r.slope_y * s.cz; \
    } while (0)

static ray_space_corners triangle_to_ray_space(sheared_rays r, uint axis,
                                               __global const float* at)
{
    ray_space_corners s;
    if (axis == 0) {
        RSH_TO_RAY_SPACE(1, 2, 0, r.origin_y, r.origin_z, r.origin_x);
    } else if (axis == 1) {
        RSH_TO_RAY_SPACE(2, 0, 1, r.origin_z, r.origin_x, r.origin_y);
    } else if (axis == 2) {
        RSH_TO_RAY_SPACE(0, 1, 2, r.origin_x, r.origin_y, r.origin_z);
    } else {
        floatv corner[9];
        for (uint i = 0; i < 9; ++i) corner[i] = (floatv)(at[16 * i]);
        s = to_ray_space(r, corner);
    }
    return s;
}

/* Hits without those that mesh/leaving.h says are none, of the lanes whose hit may be doubtful,
 * a bit each. */
RSH_CALLED static intv without_separated(const ray_packet* packet, uint v,
                                         __global const float* at, intv is_hit, floatv t,
                                         uint near)
{
    const triangle_points points = {(float3)(at[0], at[16], at[32]),
                                    (float3)(at[48], at[64], at[80]),
                                    (float3)(at[96], at[112], at[128])};
    const floatv limit =
        (floatv)(RSH_DOUBTFUL_DEPTH * triangle_extent(points)) * fabs(packet->ray[v].inverse_z);
    uint separated = 0;
    for (near &= RSH_LANE_BITS(t <= limit); near; near &= near - 1) {
        const uint k = 31 - clz(near & -near);
        const uint ray = ray_of(*packet->tile, packet->b, RSH_WIDTH * v + k);
        if (is_separated(packet->left, ray, points)) separated |= 1u << k;
    }
    return is_hit & ~mask_of_bits(separated);
}

/* Hits with a triangle that the rays have not left. */
RSH_CALLED static intv without_left(const ray_packet* packet, uint v, __global const float* at,
                                    uint triangle, intv is_hit, floatv t)
{
    const uintv skip = packet->skip[v];
    is_hit &= skip != (uintv)(triangle);
    const uint near =
        RSH_LANE_BITS(is_hit & (t <= packet->doubtful_t[v]) & (skip != (uintv)(RSH_NO_HIT)));
    return near ? without_separated(packet, v, at, is_hit, t, near) : is_hit;
}

/* Hits of a block that never became a packet, as nothing came near it. */
static void store_misses(ray_tile tile, uint b, __global const rsh_ray* rays,
                         __global rsh_hit* hits)
{
    const float none = as_float(RSH_NO_HIT);
    for (uint r = 0; r < 4; ++r) {
        const uint i = ray_of(tile, b, 4 * r);
        if (is_whole(tile, b)) {
            __global const float* tmax = (__global const float*)(rays + i) + 7;
            vstore16((float16)(tmax[0], 0.0f, 0.0f, none, tmax[8], 0.0f, 0.0f, none, tmax[16],
                               0.0f, 0.0f, none, tmax[24], 0.0f, 0.0f, none),
                     0, (__global float*)(hits + i));
            continue;
        }
        for (uint k = 0; k < 4; ++k) {
            const uint ray = ray_of(tile, b, 4 * r + k);
            if (ray != RSH_NO_RAY)
                hits[ray] = (rsh_hit){rays[ray].direction_tmax.w, 0.0f, 0.0f, RSH_NO_HIT};
        }
    }
}

#if RSH_WIDTH > 1
/* row: t u v primitive of sixteen rays, four of which lie in a row. */
static void store_whole_packet(float16* row, ray_tile tile, uint b, __global rsh_hit* hits)
{
    transpose_fours(row);
    const float16 four[4] = {(float16)(row[0].s0123, row[1].s0123, row[2].s0123, row[3].s0123),
                             (float16)(row[0].s4567, row[1].s4567, row[2].s4567, row[3].s4567),
                             (float16)(row[0].s89ab, row[1].s89ab, row[2].s89ab, row[3].s89ab),
                             (float16)(row[0].scdef, row[1].scdef, row[2].scdef, row[3].scdef)};
    for (uint r = 0; r < 4; ++r)
        vstore16(four[r], 0, (__global float*)(hits + ray_of(tile, b, 4 * r)));
}
#endif

RSH_CALLED static void store_packet_hits(const ray_packet* packet, ray_tile tile, uint b,
                                         __global rsh_hit* hits)
{
    floatv t[RSH_VECTORS];
    for_each_vector(v) {
        const intv is_miss = as_intv(packet->primitive[v]) == (intv)((int)RSH_NO_HIT);
        t[v] = select(packet->ray[v].tmax, packet->given_tmax[v], is_miss);
    }
#if RSH_WIDTH > 1
    if (is_whole(tile, b)) {
        float16 row[4] = {joined(t), joined(packet->u), joined(packet->v),
                          as_float16(joined_uints(packet->primitive))};
        store_whole_packet(row, tile, b, hits);
        return;
    }
#endif
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(tile, b, k);
        if (i == RSH_NO_RAY) continue;
        const uint primitive = ((const uint*)packet->primitive)[k];
        vstore4((float4)(lane_of(t, k), lane_of(packet->u, k), lane_of(packet->v, k),
                         as_float(primitive)),
                0, (__global float*)(hits + i));
    }
}

static void store_packet_occlusion(const ray_packet* packet, ray_tile tile, uint b,
                                   __global uint* occlusion, uint bit)
{
    uint hidden = 0;
    for_each_vector(v)
        hidden |= RSH_LANE_BITS(as_intv(packet->primitive[v]) != (intv)((int)RSH_NO_HIT))
                  << (RSH_WIDTH * v);
    for (; hidden; hidden &= hidden - 1)
        occlusion[ray_of(tile, b, 31 - clz(hidden & -hidden))] |= bit;
}

#if RSH_ALL_HITS
/* packet: 0 where nothing came near the block. */
static void store_packet_counts(const ray_packet* packet, ray_tile tile, uint b,
                                __global uint* counts)
{
    const uint none[16] = {0};
    const uint* count = packet ? (const uint*)packet->count : none;
    for (uint r = 0; r < 4; ++r) {
        if (is_whole(tile, b)) {
            vstore4(vload4(r, count), 0, counts + ray_of(tile, b, 4 * r));
            continue;
        }
        for (uint k = 4 * r; k < 4 * r + 4; ++k) {
            const uint i = ray_of(tile, b, k);
            if (i != RSH_NO_RAY) counts[i] = count[k];
        }
    }
}
#endif

#endif
