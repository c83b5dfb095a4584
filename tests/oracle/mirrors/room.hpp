// room.hpp - three spheres in a sphere, all of them mirrors, so that no path ends; and rays that
// start between them.
#pragma once

#include <vector>

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace oracle {

struct MirrorRoom {
    test::Mesh mesh;
    std::vector<test::Float3> normals;  // at the vertices; empty: flat
};

// The outer sphere has the radius 1 and the centre 0. 80 * 4^level triangles; with the spheres'
// normals at the corners, or none.
MirrorRoom mirror_room(uint32_t level, bool is_smooth);

// Whether the side of (v1 - v0) x (v2 - v0) of this triangle is the side of the room: that of the
// inner spheres is.
bool faces_the_room(const MirrorRoom& room, uint32_t triangle);

rsh_material mirror_material();

std::vector<rsh_ray> rays_in_mirror_room(test::Random& random, uint32_t count);

}  // namespace oracle
