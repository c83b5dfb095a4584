/* brute_force.cl - every ray against every triangle: the yardstick of all engines.
 *   hits       out     closest
 *   occlusion  in/out  any: a bit per ray
 * A work-item holds RSH_VECTORS_PER_ITEM vectors of rays while the triangles pass.
 */
#include "mesh/intersect.h"
#include "tuning.h"

#define RSH_RAYS_PER_ITEM (RSH_VECTORS_PER_ITEM * RSH_WIDTH)

/* Lanes behind the end, and inactive rays, get an empty interval of t: they hit nothing. */
static sheared_rays load_sheared_rays(__global const rsh_ray* rays, uint first, uint ray_count)
{
    float lanes[8][RSH_WIDTH];
    for (uint i = 0; i < RSH_WIDTH; ++i) {
        const rsh_ray ray = rays[min(first + i, ray_count - 1)];
        const bool is_used = first + i < ray_count && is_active(ray);
        float row[8];
        vstore8((float8)(ray.origin_tmin, ray.direction_tmax), 0, row);
        for (uint f = 0; f < 8; ++f) lanes[f][i] = row[f];
        if (!is_used) lanes[7][i] = -1.0f;
    }
    return shear_rays(load_lanes(lanes[0]), load_lanes(lanes[1]), load_lanes(lanes[2]),
                      load_lanes(lanes[4]), load_lanes(lanes[5]), load_lanes(lanes[6]),
                      load_lanes(lanes[3]), load_lanes(lanes[7]));
}

static void store_lane_hits(__global const rsh_ray* rays, __global rsh_hit* hits, uint first,
                            uint ray_count, const closest_hits* best)
{
    float t[RSH_WIDTH], u[RSH_WIDTH], v[RSH_WIDTH];
    uint primitive[RSH_WIDTH];
    store_lanes(best->t, t);
    store_lanes(best->u, u);
    store_lanes(best->v, v);
    store_lanes(best->primitive, primitive);
    for (uint i = 0; i < RSH_WIDTH && first + i < ray_count; ++i) {
        const bool is_hit = primitive[i] != RSH_NO_HIT;
        hits[first + i] = (rsh_hit){is_hit ? t[i] : rays[first + i].direction_tmax.w,
                                    is_hit ? u[i] : 0.0f, is_hit ? v[i] : 0.0f, primitive[i]};
    }
}

static void store_lane_occlusion(__global uint* occlusion, uint bit, uint first, uint ray_count,
                                 const closest_hits* best)
{
    uint primitive[RSH_WIDTH];
    store_lanes(best->primitive, primitive);
    for (uint i = 0; i < RSH_WIDTH && first + i < ray_count; ++i)
        if (primitive[i] != RSH_NO_HIT) occlusion[first + i] |= bit;
}

__kernel void rsh_brute_force(mesh_view mesh, __global const float* vertices,
                              __global const uint* indices, __global const rsh_ray* rays,
                              uint ray_count, __global rsh_hit* hits, __global uint* occlusion,
                              uint occlusion_bit)
{
    const uint first = get_global_id(0) * RSH_RAYS_PER_ITEM;
    if (first >= ray_count) return;
    sheared_rays sheared[RSH_VECTORS_PER_ITEM];
    closest_hits best[RSH_VECTORS_PER_ITEM];
    for (int b = 0; b < RSH_VECTORS_PER_ITEM; ++b) {
        sheared[b] = load_sheared_rays(rays, first + b * RSH_WIDTH, ray_count);
        best[b] = no_hits();
    }
    for (uint i = 0; i < mesh.triangle_count; ++i) {
        triangle_points p;
        if (!load_triangle(mesh, vertices, indices, i, &p)) continue;
        floatv corner[9];
        broadcast_triangle(p, corner);
        for (int b = 0; b < RSH_VECTORS_PER_ITEM; ++b)
            keep_closer(&best[b], intersect(sheared[b], corner), i);
    }
    for (int b = 0; b < RSH_VECTORS_PER_ITEM; ++b) {
        if (occlusion_bit)
            store_lane_occlusion(occlusion, occlusion_bit, first + b * RSH_WIDTH, ray_count,
                                 &best[b]);
        else
            store_lane_hits(rays, hits, first + b * RSH_WIDTH, ray_count, &best[b]);
    }
}
