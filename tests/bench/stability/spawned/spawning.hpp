// spawning.hpp - what of a scene rsh_spawn must know besides its triangles and the rays that hit
// them: of what they are, the lamp, and which ray each hit sends out.
#pragma once

#include <rsh/rsh.h>

#include <vector>

namespace bench::stability {

struct Spawning {
    std::vector<uint32_t> kinds;  // RSH_SPAWN_..., per ray
    std::vector<rsh_material> materials;
    std::vector<uint32_t> material_ids;  // per triangle
    rsh_light light;
};

}  // namespace bench::stability
