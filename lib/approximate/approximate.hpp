// approximate.hpp - an approximate frame traces the pixels of a grid, then, from grid to finer grid, those
// beside them that are not like their neighbours; see kernels/approximate/types.h.
#pragma once

#include <rsh/rsh.h>

#include "approximate/types.h"
#include "device/cl/recorder.hpp"

namespace rsh {

pixel_grid grid_of(cl_uint width, cl_uint height, cl_uint step);

// Some pixels of the screen, as a wave.
struct PixelPass {
    pixel_grid grid;
    cl_mem pixels;  // numbers; NULL: those of the grid
    cl_uint count;
    cl_mem screen_rays, screen_hits, picture;  // of all pixels
    cl_mem rays, hits, colour;                 // of the wave
};

// Gives the wave its rays and hits.
void take_pixels(Recorder& recorder, const PixelPass& pass);
// Gives the picture the wave's colours.
void put_pixels(Recorder& recorder, const PixelPass& pass);

// The pixels beside those of a grid, whose colours are known.
struct BlendPass {
    const rsh_scene* scene;
    pixel_grid grid;
    float tolerance;
    cl_mem hits, picture;  // of all pixels
    cl_mem listed;         // out: words, those that are not RSH_NO_HIT are pixels to trace
};

void blend_pixels(Recorder& recorder, const BlendPass& pass);
// Words of `listed`.
cl_uint listed_words(const pixel_grid& grid);

}  // namespace rsh
