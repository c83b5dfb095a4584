// layers.hpp - a scene in which each ray crosses four surfaces: bumpy spheres, one in the other, and
// rays from within the innermost.
#pragma once

#include "stability/family.hpp"

namespace bench::queries {

// `side` squared rays from one pinhole, or in no order from and to anywhere.
stability::Scene layers(uint32_t triangles, uint32_t side, bool is_coherent);

}  // namespace bench::queries
