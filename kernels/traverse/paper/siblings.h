/* siblings.h - 16 nodes with a common parent against one triangle. */
#ifndef RSH_TRAVERSE_PAPER_SIBLINGS_H
#define RSH_TRAVERSE_PAPER_SIBLINGS_H

#include "bvh/layout.h"
#include "rays/box_node.h"

#define RSH_GROUP_FLOATS 224 /* of rsh_node_group */
typedef struct rsh_siblings {
    rsh_bundles bundles;
    rsh_bundle common; /* its signs: those of all directions per axis, or 0 */
} rsh_siblings;

static void load_siblings(rsh_siblings* nodes, __global const float* group)
{
    for (uint v = 0; v < RSH_VECTORS; ++v)
        nodes->bundles.limit[v] = load_lanes(group + 192 + RSH_WIDTH * v) * RSH_RAISED;
    for (uint axis = 0; axis < 3; ++axis) {
        __global const float* row = group + 16 * axis;
        for (uint v = 0; v < RSH_VECTORS; ++v)
            set_bundles_axis(&nodes->bundles, axis, v, load_lanes(row + RSH_WIDTH * v),
                             load_lanes(row + 48 + RSH_WIDTH * v),
                             load_lanes(row + 96 + RSH_WIDTH * v),
                             load_lanes(row + 144 + RSH_WIDTH * v));
        float low = INFINITY, high = -INFINITY;
        for (uint k = 0; k < 16; ++k) {
            low = fmin(low, row[96 + k]);
            high = fmax(high, row[144 + k]);
        }
        nodes->common.slab[axis].sign = low > 0.0f ? 1 : high < 0.0f ? -1 : 0;
    }
}

/* bounds: clusters, see bvh/layout.h. */
static uint siblings_meeting(const rsh_siblings* nodes, __global const float* bounds,
                             uint place)
{
    __global const float* corner = bounds + cluster_at(place / 16) + place % 16;
    float low[3], high[3], reach = 0.0f;
    for (uint axis = 0; axis < 3; ++axis) {
        const float a = corner[16 * axis], b = corner[48 + 16 * axis],
                    c = corner[96 + 16 * axis];
        low[axis] = fmin(a, fmin(b, c));
        high[axis] = fmax(a, fmax(b, c));
        reach = fmax(reach, fmax(fabs(low[axis]), fabs(high[axis])));
    }
    const float pad = reach < INFINITY ? pad_of(reach) : 0.0f;
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] -= pad;
        high[axis] += pad;
    }
    return bundles_meeting(&nodes->bundles, &nodes->common, low, high);
}

#endif
