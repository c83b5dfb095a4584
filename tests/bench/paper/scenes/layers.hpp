// layers.hpp - sheets behind each other, seen in a plane mirror: whatever their number, a ray hits the first
// one, and there are as many triangles in all.
#pragma once

#include "frame/still_scene.hpp"

namespace bench::paper {

StillScene make_layers(int64_t triangles, uint32_t layers);

}  // namespace bench::paper
