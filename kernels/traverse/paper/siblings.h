/* siblings.h - 16 nodes with a common parent against one triangle. */
#ifndef RSH_TRAVERSE_PAPER_SIBLINGS_H
#define RSH_TRAVERSE_PAPER_SIBLINGS_H

#include "bvh/layout.h"
#include "rays/box_node.h"

#define RSH_GROUP_FLOATS 224 /* of box_node16 */
typedef struct sibling_nodes {
    interval_packet16 packets;
    interval_packet common; /* its signs: those of all directions per axis, or 0 */
} sibling_nodes;

static void load_siblings(sibling_nodes* nodes, __global const float* group)
{
    for_each_vector(v)
        nodes->packets.limit[v] = load_lanes(group + 192 + RSH_WIDTH * v) * RSH_RAISED;
    for (uint axis = 0; axis < 3; ++axis) {
        __global const float* row = group + 16 * axis;
        for_each_vector(v)
            set_packets_axis(&nodes->packets, axis, v, load_lanes(row + RSH_WIDTH * v),
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

/* Which of the 16 nodes meet the triangle at a place in the leaves of the scene's BVH. */
static uint siblings_meeting(const sibling_nodes* nodes, __global const float* bounds,
                             uint place)
{
    __global const float* corner = bounds + leaf_at(place / 16) + place % 16;
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
    return packets_meeting(&nodes->packets, &nodes->common, low, high);
}

#endif
