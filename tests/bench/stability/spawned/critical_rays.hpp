// critical_rays.hpp - rays at glass that is lighter on the far side, so that a hair's breadth
// decides between refraction and total reflection.
#pragma once

#include "stability/spawned/crowd.hpp"

namespace bench::stability {

// 1.0001 .. 3, and one over that: then light is reflected outside.
std::vector<float> critical_indices(test::Random& random, uint32_t count);

// At sines of 1 / index, or index, and up to 2^14 ulp beside them. `index_of`: per triangle.
test::Rays critical_rays(test::Random& random, const Crowd& crowd,
                         const std::vector<float>& index_of, uint32_t side);

}  // namespace bench::stability
