/* refit_quality.h - whether triangles that moved still make compact leaves in the order that
 * was made for them earlier. Compares surfaces of boxes at some places of the order, then and
 * now. */
#ifndef RSH_BVH_REFIT_QUALITY_H
#define RSH_BVH_REFIT_QUALITY_H

#include "bvh/leaves.h"
#include "tuning.h"

/* Half the surfaces of 16 boxes, added up; empty ones do not count. */
static float surface_of_boxes(const boxes16* boxes)
{
    float total = 0.0f;
    for_each_vector(v) {
        floatv side[3];
        for (uint axis = 0; axis < 3; ++axis)
            side[axis] = boxes->high[axis][v] - boxes->low[axis][v];
        const floatv surface = side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
        float lane[RSH_WIDTH];
        store_lanes(select((floatv)(0.0f), surface, side[0] >= (floatv)(0.0f)), lane);
        for (uint k = 0; k < RSH_WIDTH; ++k) total += lane[k];
    }
    return total;
}

/* Grows the box low .. high to hold 16 boxes. */
static void add_boxes(const boxes16* boxes, float* low, float* high)
{
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = fmin(low[axis], smallest_lane(boxes->low[axis]));
        high[axis] = fmax(high[axis], largest_lane(boxes->high[axis]));
    }
}

/* Sample `me` of RSH_QUALITY_SAMPLES: 16 ranges of 16 triangles, one after the other or 16,
 * 256, ... ranges apart. 0 where there are fewer ranges than that. leaves: the number of
 * ranges. */
RSH_CALLED static refit_quality quality_at(uint me, mesh_view mesh,
                                           __global const float* vertices,
                                           __global const uint* indices,
                                           __global const uint* order, uint leaves)
{
    const uint step = 1u << (4 * (me / RSH_QUALITY_SAMPLES_PER_STEP)), span = 16 * step;
    refit_quality quality = {0.0f, 0.0f, 0.0f};
    if (step > 1 && span > leaves) return quality;
    const ulong room = leaves > span ? leaves - span : 0;
    const uint first =
        room * (me % RSH_QUALITY_SAMPLES_PER_STEP) / (RSH_QUALITY_SAMPLES_PER_STEP - 1);
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint c = first; c < min(first + span, leaves); c += step) {
        corner_rows corners;
        boxes16 boxes;
        float own_low[3] = {INFINITY, INFINITY, INFINITY};
        float own_high[3] = {-INFINITY, -INFINITY, -INFINITY};
        load_corners(mesh, vertices, indices, order, 16 * c, &corners);
        boxes_of_corners(&corners, &boxes);
        add_boxes(&boxes, own_low, own_high);
        quality.triangles += surface_of_boxes(&boxes);
        quality.leaves += surface_of(own_low, own_high);
        for (uint axis = 0; axis < 3; ++axis) {
            low[axis] = fmin(low[axis], own_low[axis]);
            high[axis] = fmax(high[axis], own_high[axis]);
        }
    }
    quality.range = surface_of(low, high);
    return quality;
}

/* Whether the order has not degraded; false as well where a surface is NaN. */
RSH_CALLED static bool order_serves(__global const refit_quality* now,
                                    __global const refit_quality* then)
{
    for (uint i = 0; i < RSH_QUALITY_SAMPLES; i += RSH_QUALITY_SAMPLES_PER_STEP) {
        refit_quality a = now[i], b = then[i];
        for (uint k = 1; k < RSH_QUALITY_SAMPLES_PER_STEP; ++k) {
            a.triangles += now[i + k].triangles;
            a.leaves += now[i + k].leaves;
            a.range += now[i + k].range;
            b.triangles += then[i + k].triangles;
            b.leaves += then[i + k].leaves;
            b.range += then[i + k].range;
        }
        if (!(a.leaves * b.triangles <= RSH_DEGRADED * b.leaves * a.triangles)) return false;
        if (!(a.range * b.triangles <= RSH_DEGRADED * b.range * a.triangles)) return false;
    }
    return true;
}

#endif
