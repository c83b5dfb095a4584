/* join_boxes.cl - nodes of shape `box` above the tiles, level by level: a minimum of minima is
 * as tight as if it were fitted to the rays.
 *   in   in   from word first_word on, nodes of `level`: a box_node16 holds the children of one
 *   out  out  nodes of level + 1: a box_node16 holds 16 nodes of `level`
 *   list_count  in  how many rays of a list there are; NULL: all
 * A work-item makes a box_node16.
 */
#include "rays/box_node.h"
#include "rays/levels.h"

/* The lane of a node, from its children's: low and high of origins, of directions, tmax. */
static void join_node16(__global const float* in, float* row)
{
    for (uint f = 0; f < 13; ++f) {
        const bool is_low = f < 3 || (f >= 6 && f < 9);
        float best = in[16 * f];
        for (uint k = 1; k < 16; ++k) {
            const float other = in[16 * f + k];
            best = is_low ? fmin(best, other) : fmax(best, other);
        }
        row[f] = best;
    }
    row[13] = in[16 * 13];
}

static void clear_row(float* row)
{
    for (uint f = 0; f < 12; ++f) row[f] = f < 3 || (f >= 6 && f < 9) ? INFINITY : -INFINITY;
    row[12] = -1.0f;
    row[13] = 0.0f;
}

__kernel void rsh_join_boxes(ray_levels shape, __global const uint* list_count, uint level,
                             __global const float* in, uint first_word, uint first_in,
                             __global float* out, uint first_out)
{
    const ray_levels levels = counted_levels(shape, list_count);
    const uint me = get_global_id(0);
    if (me >= levels.width[level + 1] * levels.height[level + 1]) return;
    __global float* node16 = out + 224ul * (first_out + me);
    for (uint k = 0; k < 16; ++k) {
        const uint node = child_of(&levels, level, me, k);
        float row[14];
        if (node == RSH_NO_NODE)
            clear_row(row);
        else
            join_node16(in + first_word + 224ul * (first_in + node), row);
        for (uint f = 0; f < 14; ++f) node16[16 * f + k] = row[f];
    }
}
