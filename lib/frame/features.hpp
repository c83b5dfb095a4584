// features.hpp - what a scene needs, so that nothing else is compiled, allocated or launched.
// Looks at host copies and at which buffers are there; never at device memory.
#pragma once

#include <rsh/rsh.h>

namespace rsh {

// See rsh_find_features.
void find_features(rsh_scene& scene, const rsh_material* materials, const rsh_light* lights);

}  // namespace rsh
