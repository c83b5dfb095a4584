// diffuse.hpp - one incoherent ray per primary hit, on the host: its direction is distributed
// with the cosine to the surface's normal and drawn from a hash of the pixel, so that
// neighbours have nothing in common. The same input gives the same rays.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

#include <rsh/rsh_types.h>

namespace bench {

// `rays` are primary rays and become the diffuse rays of their `hits`, inactive where nothing
// is hit.
void make_diffuse(const std::vector<glm::vec3>& positions,
                  const std::vector<glm::uvec3>& triangles, const std::vector<rsh_hit>& hits,
                  std::vector<rsh_ray>& rays);

}  // namespace bench
