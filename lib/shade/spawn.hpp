// spawn.hpp - secondary and shadow rays at the hits of a wave of rays.
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"

namespace rsh {

void spawn(Recorder& recorder, const rsh_spawn_desc& desc);

}  // namespace rsh
