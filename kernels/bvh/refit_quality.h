/* refit_quality.h - whether triangles that moved still make compact clusters in the order that
 * was made for them earlier: surfaces of boxes, at some places of the order, then and now. */
#ifndef RSH_BVH_REFIT_QUALITY_H
#define RSH_BVH_REFIT_QUALITY_H

#include "bvh/leaves.h"

/* An order is worn when its boxes have so many times the surface they had when it was made,
 * against that of their triangles, which turn and grow themselves. Rays meet boxes by their
 * surface; above this, tracing loses more than sorting costs. */
#define RSH_WORN 1.2f

/* Of boxes that hold something, added up. */
static float surface_of_boxes(const rsh_boxes* boxes)
{
    float total = 0.0f;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
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

/* The box around 16 boxes, and around what `low` and `high` hold already. */
static void add_boxes(const rsh_boxes* boxes, float* low, float* high)
{
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = fmin(low[axis], smallest_lane(boxes->low[axis]));
        high[axis] = fmax(high[axis], largest_lane(boxes->high[axis]));
    }
}

/* Place `me` of RSH_SURVEYS: 16 clusters, one after the other or 16, 256, ... apart, the boxes
 * around their triangles, around each of them, and around all. Nothing where there are fewer
 * clusters than that. */
static rsh_survey survey_at(uint me, rsh_mesh mesh, __global const float* vertices,
                            __global const uint* indices, __global const uint* order,
                            uint clusters)
{
    const uint step = 1u << (4 * (me / RSH_SURVEYS_PER_STEP)), span = 16 * step;
    rsh_survey survey = {0.0f, 0.0f, 0.0f};
    if (step > 1 && span > clusters) return survey;
    const ulong room = clusters > span ? clusters - span : 0;
    const uint first = room * (me % RSH_SURVEYS_PER_STEP) / (RSH_SURVEYS_PER_STEP - 1);
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint c = first; c < min(first + span, clusters); c += step) {
        rsh_corner_rows corners;
        rsh_boxes boxes;
        float own_low[3] = {INFINITY, INFINITY, INFINITY};
        float own_high[3] = {-INFINITY, -INFINITY, -INFINITY};
        load_corners(mesh, vertices, indices, order, 16 * c, &corners);
        boxes_of_corners(&corners, &boxes);
        add_boxes(&boxes, own_low, own_high);
        survey.triangles += surface_of_boxes(&boxes);
        survey.clusters += surface_of(own_low, own_high);
        for (uint axis = 0; axis < 3; ++axis) {
            low[axis] = fmin(low[axis], own_low[axis]);
            high[axis] = fmax(high[axis], own_high[axis]);
        }
    }
    survey.run = surface_of(low, high);
    return survey;
}

/* Whether the order is not worn; false as well where a surface is no number. */
static bool order_serves(__global const rsh_survey* now, __global const rsh_survey* then)
{
    for (uint i = 0; i < RSH_SURVEYS; i += RSH_SURVEYS_PER_STEP) {
        rsh_survey a = now[i], b = then[i];
        for (uint k = 1; k < RSH_SURVEYS_PER_STEP; ++k) {
            a.triangles += now[i + k].triangles;
            a.clusters += now[i + k].clusters;
            a.run += now[i + k].run;
            b.triangles += then[i + k].triangles;
            b.clusters += then[i + k].clusters;
            b.run += then[i + k].run;
        }
        if (!(a.clusters * b.triangles <= RSH_WORN * b.clusters * a.triangles)) return false;
        if (!(a.run * b.triangles <= RSH_WORN * b.run * a.triangles)) return false;
    }
    return true;
}

#endif
