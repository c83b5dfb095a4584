// spawn_wave.hpp - rsh_spawn_wave and rsh_gather_wave: the passes of shade/wave.hpp over a whole wave.
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"

namespace rsh {

Layout spawn_wave_scratch(const Context& context, const rsh_spawn_wave_desc& desc);
void spawn_wave(Recorder& recorder, const rsh_spawn_wave_desc& desc);
void gather_wave(Recorder& recorder, const rsh_gather_wave_desc& desc);

}  // namespace rsh
