/* spawned_ray.h - what the kernels that make rays write. */
#ifndef RSH_SHADE_SPAWNED_RAY_H
#define RSH_SHADE_SPAWNED_RAY_H

#include "mesh/algebra.h"

static rsh_ray inactive_ray(void)
{
    rsh_ray ray;
    ray.origin_tmin = (float4)(0.0f);
    ray.direction_tmax = (float4)(0.0f, 0.0f, 0.0f, -1.0f);
    return ray;
}

static rsh_ray ray_from(float3 origin, float3 direction, float tmax)
{
    rsh_ray ray;
    ray.origin_tmin = (float4)(origin, 0.0f);
    ray.direction_tmax = (float4)(direction, tmax);
    return ray;
}

/* The triangle that a spawned ray has left. */
static void store_skip(__global uint* skip, uint i, rsh_ray spawned, rsh_hit hit)
{
    if (skip) skip[i] = is_active(spawned) ? hit.primitive : RSH_NO_HIT;
}

/* One atomic per work-item, which makes a range of rays. */
static void add_active(__global uint* active_count, uint active)
{
    if (active_count && active > 0) atomic_add(active_count, active);
}

#endif
