/* take_pixels.cl - rays and hits of some pixels of the screen, packed, and the way back of their colours.
 *   pixels  in  the number of each; NULL: those of the grid
 */
#include "approximate/types.h"
#include "lanes/stride.h"

static uint pixel_of(pixel_grid grid, __global const uint* pixels, uint i)
{
    if (pixels) return pixels[i];
    return grid.step * (i / grid.columns * grid.width + i % grid.columns);
}

__kernel void rsh_take_pixels(pixel_grid grid, __global const uint* pixels, uint count,
                              __global const float8* screen_rays,
                              __global const uint4* screen_hits, __global float8* rays,
                              __global uint4* hits)
{
    const strided_range mine = my_elements(count);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const uint pixel = pixel_of(grid, pixels, i);
        rays[i] = screen_rays[pixel];
        hits[i] = screen_hits[pixel];
    }
}

__kernel void rsh_put_pixels(pixel_grid grid, __global const uint* pixels, uint count,
                             __global const float4* colour, __global float4* picture)
{
    const strided_range mine = my_elements(count);
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        picture[pixel_of(grid, pixels, i)] = colour[i];
}
