// mirror_room.hpp - three spheres in a sphere, all of them mirrors of 1,280 triangles.
#pragma once

#include "support/scene.hpp"

namespace test {

// 20 * 4^level triangles, counter-clockwise from outside, corners on the sphere around 0.
Mesh icosphere(uint32_t level);

// The outer sphere has the radius 1 and the centre 0. 80 * 4^level triangles; with the spheres'
// normals at the corners, or none.
Scene mirror_room(uint32_t level, bool is_smooth);

// Of a point between the spheres.
bool is_in_mirror_room(Float3 point);

}  // namespace test
