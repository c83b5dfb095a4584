/* build_boxes.cl - the hierarchy over the rays with the bound `box`, bottom-up.
 *   rays   in   level 0
 *   nodes  out  groups of 16 nodes; see rsh_node_group
 * A work-item reads the 256 rays of a tile once and writes its 16 blocks. Does not test anything
 * against the scene.
 */
#include "box.h"
#include "tile.h"

/* Rows of a group: origin low, high, direction low, high (3 each), tmax, is_converging. */
#define RSH_NODE_ROWS 14

/* Rays of a block, both ends of their ranges: x y z of the origin, -, x y z of the direction, -.
 */
typedef struct rsh_range {
    float8 low, high;
    float largest; /* origin component that the padding must cover */
    float tmax;    /* negative: no active ray */
} rsh_range;

static void add_ray(rsh_range* range, rsh_ray ray, uint is_converging)
{
    if (!is_active(ray)) return;
    float8 r = (float8)(ray.origin_tmin, ray.direction_tmax);
    float tmax = ray.direction_tmax.w;
    const float4 o = fabs(ray.origin_tmin);
    range->largest = fmax(range->largest, fmax(o.x, fmax(o.y, o.z)));
    if (is_converging) {
        const float4 end = ray.origin_tmin + ray.direction_tmax;
        if (!(tmax <= 1.0f) || !is_finite3(end.xyz)) {
            range->low = (float8)(-INFINITY);
            range->high = (float8)(INFINITY);
        }
        r = (float8)(end, -ray.direction_tmax);
        tmax = 1.0f;
        const float4 e = fabs(end);
        range->largest = fmax(range->largest, fmax(e.x, fmax(e.y, e.z)));
    }
    range->low = fmin(range->low, r);
    range->high = fmax(range->high, r);
    range->tmax = fmax(range->tmax, tmax);
}

__kernel void rsh_build_blocks(rsh_levels shape, __global const rsh_ray* rays,
                               uint is_converging, __global float* groups)
{
    const uint me = get_global_id(0);
    if (me >= tile_count(shape)) return;
    const rsh_tile tile = tile_at(shape, me);
    float rows[RSH_NODE_ROWS][16];
    for (uint b = 0; b < 16; ++b) {
        rsh_range range = {(float8)(INFINITY), (float8)(-INFINITY), 0.0f, -1.0f};
        for (uint k = 0; k < 16; ++k) {
            const uint i = ray_of(tile, b, k);
            if (i != RSH_NO_RAY) add_ray(&range, rays[i], is_converging);
        }
        float low[8], high[8];
        vstore8(range.low, 0, low);
        vstore8(range.high, 0, high);
        const float pad = pad_of(range.largest);
        for (uint axis = 0; axis < 3; ++axis) {
            rows[axis][b] = low[axis] - pad;
            rows[3 + axis][b] = high[axis] + pad;
            rows[6 + axis][b] = low[4 + axis];
            rows[9 + axis][b] = high[4 + axis];
        }
        rows[12][b] = range.tmax;
        rows[13][b] = as_float(is_converging);
    }
    __global float* out = groups + 16ul * RSH_NODE_ROWS * me;
    for (uint f = 0; f < RSH_NODE_ROWS; ++f)
        for (uint b = 0; b < 16; ++b) out[16 * f + b] = rows[f][b];
}
