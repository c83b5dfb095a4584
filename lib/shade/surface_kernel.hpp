// surface_kernel.hpp - which variant of the kernels that work on hits (programs/surface.cl) a
// scene needs: one program per set of features (kernels/surface/features.h).
#pragma once

#include <rsh/rsh.h>

#include "device/programs/programs.hpp"

namespace rsh {

inline KernelName surface_kernel(const rsh_scene& scene, const char* kernel) {
    const auto define = [&scene](const char* name, rsh_features bit) {
        return std::string(" -D ") + name + (scene.features & bit ? "=1" : "=0");
    };
    return {"programs/surface", kernel,
            define("RSH_SMOOTH_NORMAL", RSH_FEATURE_SMOOTH_NORMAL) +
                define("RSH_TEXTURE", RSH_FEATURE_TEXTURE) +
                define("RSH_ENVIRONMENT_IMAGE", RSH_FEATURE_ENVIRONMENT_IMAGE),
            true};
}

}  // namespace rsh
