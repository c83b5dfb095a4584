// shade.hpp - what the hits of a wave of rays add to the colours of its rays.
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"

namespace rsh {

// Bit k: light k of the scene casts shadows that are asked for.
cl_uint shadow_lights(const rsh_scene& scene);

void shade(Recorder& recorder, const rsh_shade_desc& desc);
// Of colours that nothing was added to before, nor set.
void shade_first(Recorder& recorder, const rsh_shade_desc& desc);

// What a light adds to a wave, if nothing hides it, and the rays that show that.
struct LightPass {
    rsh_shade_desc shade;
    rsh_spawn_desc shadow;  // of the same hits
    cl_mem light_colour;    // a float4 per ray
    bool is_base;           // all that no shadow falls on is added as well
    bool is_first;          // as shade_first
};

void shade_lit(Recorder& recorder, const LightPass& pass);
// Once desc.occlusion says which rays met something.
void add_light(Recorder& recorder, const LightPass& pass);

}  // namespace rsh
