// spawn.hpp - rays that rsh_spawn makes on the device of those of a scene. Judges nothing.
#pragma once

#include "device.hpp"
#include "stability/spawned/spawned.hpp"

namespace bench::stability {

// Replaces the rays of the scene by what leaves their closest hits, with the triangles to skip.
Spawned spawn(const Device& device, Scene& scene);

}  // namespace bench::stability
