/* wave_origins.cl - where the rays of a packed wave come from, see rsh_spawn_wave.
 *   list_count  in   how many rays the wave before has, of ray_count at most; NULL: all
 *   branches    in   of shade/wave.cl
 *   next_count  in   how many rays the wave has; 0: branches mean nothing
 *   pixels      in   of the rays of the wave before; NULL: their numbers
 *   parents     out  of each ray, that of the wave before; NULL: not asked for
 *   inherited   out  of each ray, the pixel of its parent; NULL: likewise
 */
#include "lanes/stride.h"
#include "rays/levels.h"

static void note_origin(uint ray, uint parent, uint pixel, __global uint* parents,
                        __global uint* inherited)
{
    if (ray == RSH_NO_RAY) return;
    if (parents) parents[ray] = parent;
    if (inherited) inherited[ray] = pixel;
}

__kernel void rsh_wave_origins(uint ray_count, __global const uint* list_count,
                               __global const uint2* branches, __global const uint* next_count,
                               __global const uint* pixels, __global uint* parents,
                               __global uint* inherited)
{
    if (*next_count == 0) return;
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const uint pixel = pixels ? pixels[i] : i;
        note_origin(branches[i].x, i, pixel, parents, inherited);
        note_origin(branches[i].y, i, pixel, parents, inherited);
    }
}
