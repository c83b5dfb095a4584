/* boxes16.h - sixteen boxes side by side, and by how much boxes are padded; rays/box_node.h
 * derives it. */
#ifndef RSH_MESH_BOXES16_H
#define RSH_MESH_BOXES16_H

#include "lanes/sixteen.h"

/* largest: component of what the box holds, in size. 64u of it, and what a device flushes to
 * 0. */
static float pad_of(float largest) { return 0x1p-18f * largest + 0x1p-124f; }

/* [axis]. */
typedef struct boxes16 {
    floatv low[3][RSH_VECTORS], high[3][RSH_VECTORS];
} boxes16;

static void load_boxes(__global const float* node, boxes16* boxes)
{
    for (uint axis = 0; axis < 3; ++axis)
        for_each_vector(v) {
            boxes->low[axis][v] = load_lanes(node + 16 * axis + RSH_WIDTH * v);
            boxes->high[axis][v] = load_lanes(node + 48 + 16 * axis + RSH_WIDTH * v);
        }
}

#endif
