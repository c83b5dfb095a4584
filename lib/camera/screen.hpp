// screen.hpp - the camera as the kernels of camera/rasterize.cl need it: axes scaled into
// range, their inverse, and how much rounding can turn a ray. Launches nothing.
#pragma once

#include <rsh/rsh.h>

#include "camera/types.h"

namespace rsh {

// Sets the members of `screen` that depend on the camera alone.
void set_camera(screen_setup& screen, const rsh_camera& camera);

}  // namespace rsh
