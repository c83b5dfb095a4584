/* clear_colour.cl - begins a frame: black, alpha 1 where the pixel sees a triangle.
 *   hits       in   primary hits
 *   colour     out
 *   hit_count  out  grows by the pixels with a hit
 */
#include "lanes/stride.h"
#include "rsh/rsh_types.h"

__kernel void rsh_clear_colour(__global const rsh_hit* hits, uint pixel_count,
                               __global float4* colour, __global uint* hit_count)
{
    const strided_range mine = my_elements(pixel_count);
    uint seen = 0;
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const uint is_hit = hits[i].primitive != RSH_NO_HIT;
        colour[i] = (float4)(0.0f, 0.0f, 0.0f, (float)is_hit);
        seen += is_hit;
    }
    if (seen) atomic_add(hit_count, seen);
}
