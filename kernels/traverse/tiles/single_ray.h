/* single_ray.h - a ray that goes down the tree on its own: against 16 boxes, or 16 triangles,
 * at a time. The slab test is that of rays/box_node.h, where the node is one ray.
 */
#ifndef RSH_TRAVERSE_TILES_SINGLE_RAY_H
#define RSH_TRAVERSE_TILES_SINGLE_RAY_H

#include "traverse/continue_packet.h"

typedef struct single_ray {
    uint near_row[3], far_row[3]; /* rows of a bvh_node that bound t from below, from above */
    float near_origin[3], far_origin[3], inverse[3];
    float limit;   /* tmax, raised; negative: retired */
    uint k_row[3]; /* of a corner: the axes x y z of sheared_rays */
    float k_origin[3], slope_x, slope_y, inverse_z, tmin, tmax;
    float u, v;
    uint primitive;
    const triangles_left* left; /* 0: the ray has left none */
#if RSH_FILTER
    const hit_filter* filter;
#endif
    uint skip, index; /* if there is `left`: the triangle left; the ray, in any case
                                   with RSH_ALL_HITS */
    float doubtful_t; /* the same as in ray_packet */
#if RSH_ALL_HITS
    uint count;
    hit_rows* rows; /* of the vector that it is a lane of */
    uint lane;
    hit_list* list;
#endif
} single_ray;

RSH_CALLED static single_ray single_ray_of(const ray_packet* packet, uint k)
{
    const sheared_rays* r = &packet->ray[k / RSH_WIDTH];
    const uint lane = k % RSH_WIDTH;
    single_ray ray;
    const float origin[3] = {lane_of(&r->origin_x, lane), lane_of(&r->origin_y, lane),
                             lane_of(&r->origin_z, lane)};
    for (uint axis = 0; axis < 3; ++axis) {
        const float inverse = lane_of(packet->inverse[axis], k);
        const bool is_negative = inverse < 0.0f;
        ray.inverse[axis] = inverse;
        ray.near_row[axis] = 16 * axis + (is_negative ? 48 : 0);
        ray.far_row[axis] = 16 * axis + (is_negative ? 0 : 48);
        ray.near_origin[axis] = origin[axis] + (is_negative ? -packet->pad : packet->pad);
        ray.far_origin[axis] = origin[axis] - (is_negative ? -packet->pad : packet->pad);
    }
    const uint z = ((const int*)&r->kz_is_x)[lane]   ? 0
                   : ((const int*)&r->kz_is_y)[lane] ? 1
                                                     : 2;
    for (uint i = 0; i < 3; ++i) {
        const uint axis = (z + 1 + i) % 3;
        ray.k_row[i] = 16 * axis;
        ray.k_origin[i] = origin[axis];
    }
    ray.slope_x = lane_of(&r->slope_x, lane);
    ray.slope_y = lane_of(&r->slope_y, lane);
    ray.inverse_z = lane_of(&r->inverse_z, lane);
    ray.tmin = lane_of(&r->tmin, lane);
    ray.tmax = lane_of(&r->tmax, lane);
    ray.limit = ray.tmax * RSH_RAISED;
    ray.u = lane_of(packet->u, k);
    ray.v = lane_of(packet->v, k);
    ray.primitive = ((const uint*)packet->primitive)[k];
    ray.left = packet->left;
#if RSH_FILTER
    ray.filter = packet->filter;
    ray.index = ray_of(*packet->tile, packet->b, k);
#endif
    if (ray.left || RSH_ALL_HITS) ray.index = ray_of(*packet->tile, packet->b, k);
    if (ray.left) {
        ray.skip = ((const uint*)packet->skip)[k];
        ray.doubtful_t = lane_of(packet->doubtful_t, k);
    }
#if RSH_ALL_HITS
    ray.count = ((const uint*)packet->count)[k];
    ray.rows = &packet->rows[k / RSH_WIDTH];
    ray.lane = k % RSH_WIDTH;
    ray.list = packet->list;
#endif
    return ray;
}

static void store_single_ray(const single_ray* ray, ray_packet* packet, uint k)
{
    ((float*)&packet->ray[k / RSH_WIDTH].tmax)[k % RSH_WIDTH] = ray->tmax;
    ((float*)packet->u)[k] = ray->u;
    ((float*)packet->v)[k] = ray->v;
    ((uint*)packet->primitive)[k] = ray->primitive;
#if RSH_ALL_HITS
    ((uint*)packet->count)[k] = ray->count;
#endif
}

/* Which of 16 boxes the ray can meet, and from which t on. */
static uint boxes_met_by_ray(const single_ray* ray, __global const float* node, float* near)
{
    uint met = 0;
    for_each_vector(v) {
        floatv from = (floatv)(0.0f), to = (floatv)(ray->tmax);
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv low = load_lanes(node + ray->near_row[axis] + RSH_WIDTH * v);
            const floatv high = load_lanes(node + ray->far_row[axis] + RSH_WIDTH * v);
            const floatv inverse = (floatv)(ray->inverse[axis]);
            from = greater((low - ray->near_origin[axis]) * inverse, from);
            to = lesser((high - ray->far_origin[axis]) * inverse, to);
        }
        store_lanes(from, near + RSH_WIDTH * v);
        met |= RSH_LANE_BITS(from <= to * RSH_RAISED) << (RSH_WIDTH * v);
    }
    return met;
}

/* Vector v of a leaf's triangles, in the ray's space. */
static ray_space_corners leaf_to_ray_space(const single_ray* ray, __global const float* leaf,
                                           uint v)
{
    ray_space_corners s;
    __global const float* x = leaf + ray->k_row[0] + RSH_WIDTH * v;
    __global const float* y = leaf + ray->k_row[1] + RSH_WIDTH * v;
    __global const float* z = leaf + ray->k_row[2] + RSH_WIDTH * v;
    const floatv slope_x = (floatv)(ray->slope_x), slope_y = (floatv)(ray->slope_y);
    s.az = load_lanes(z) - ray->k_origin[2];
    s.bz = load_lanes(z + 48) - ray->k_origin[2];
    s.cz = load_lanes(z + 96) - ray->k_origin[2];
    s.ax = (load_lanes(x) - ray->k_origin[0]) - slope_x * s.az;
    s.bx = (load_lanes(x + 48) - ray->k_origin[0]) - slope_x * s.bz;
    s.cx = (load_lanes(x + 96) - ray->k_origin[0]) - slope_x * s.cz;
    s.ay = (load_lanes(y) - ray->k_origin[1]) - slope_y * s.az;
    s.by = (load_lanes(y + 48) - ray->k_origin[1]) - slope_y * s.bz;
    s.cy = (load_lanes(y + 96) - ray->k_origin[1]) - slope_y * s.cz;
    return s;
}

static floatv scales_of(__global const float* leaf, uint v)
{
    floatv corner[9];
    for (uint i = 0; i < 9; ++i) corner[i] = load_lanes(leaf + 16 * i + RSH_WIDTH * v);
    return triangle_scale(corner);
}

static triangle_points points_of(__global const float* leaf, uint k)
{
    return (triangle_points){(float3)(leaf[k], leaf[16 + k], leaf[32 + k]),
                             (float3)(leaf[48 + k], leaf[64 + k], leaf[80 + k]),
                             (float3)(leaf[96 + k], leaf[112 + k], leaf[128 + k])};
}

/* Whether mesh/leaving.h says that the hit of triangle k of a leaf is none. */
static bool is_leaf_hit_left(const single_ray* ray, __global const float* leaf, uint k,
                             uint triangle, float t)
{
    if (triangle == ray->skip) return true;
    if (!(t <= ray->doubtful_t) || ray->skip == RSH_NO_HIT) return false;
    const triangle_points points = points_of(leaf, k);
    return t <= RSH_DOUBTFUL_DEPTH * triangle_extent(points) * fabs(ray->inverse_z) &&
           is_separated(ray->left, ray->index, points);
}

#endif
