/* spawned_ray.h - what the kernels that make rays write. */
#ifndef RSH_SURFACE_SPAWNED_RAY_H
#define RSH_SURFACE_SPAWNED_RAY_H

#include "surface/surface.h"

/* What a block of hits sends out. */
typedef struct sent_rays {
    float3v origin, direction;
    float tmax;
    uint bits; /* lane by lane, whether there is a ray */
} sent_rays;

/* v and w of the lanes in `bits`; of the others 0 and w of none. */
static void put_rows(float3v v, float w, uint bits, float w_of_none, floatv* row)
{
    const intv is_put = mask_of_bits(bits);
    const float3v put = select_v(lanes_of((float3)(0.0f)), v, is_put);
    row[0] = put.x;
    row[1] = put.y;
    row[2] = put.z;
    row[3] = select((floatv)(w_of_none), (floatv)(w), is_put);
}

/* To the places of the lanes (RSH_NO_RAY: none). primitive: the triangles that the rays leave, which
 * they skip; skip may be NULL. */
RSH_CALLED static void store_sent_rays(const sent_rays* sent, const uint* places,
                                       const uint* primitive, __global rsh_ray* rays,
                                       __global uint* skip)
{
    const uint bits = lanes_with_ray(places);
    floatv origin[4], direction[4];
    put_rows(sent->origin, 0.0f, sent->bits, 0.0f, origin);
    put_rows(sent->direction, sent->tmax, sent->bits, -1.0f, direction);
    store_rows4(origin, bits, (__global float*)rays, 8, places);
    store_rows4(direction, bits, (__global float*)rays + 4, 8, places);
    if (!skip) return;
    for (uint k = 0; k < RSH_WIDTH; ++k)
        if (bits >> k & 1) skip[places[k]] = sent->bits >> k & 1 ? primitive[k] : RSH_NO_HIT;
}

/* Of these rays; 0: there is none. */
RSH_CALLED static void store_sent_weights(float3v weight, uint bits, const uint* places,
                                          __global float4* weights)
{
    floatv row[4];
    put_rows(weight, 0.0f, bits, 0.0f, row);
    store_rows4(row, lanes_with_ray(places), (__global float*)weights, 4, places);
}

/* One atomic per work-item, which makes a range of rays. */
static void add_active(__global uint* active_count, uint active)
{
    if (active_count && active > 0) atomic_add(active_count, active);
}

#endif
