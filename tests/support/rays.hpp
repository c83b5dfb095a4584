// rays.hpp - bundles of rays in screen order or as a list, coherent ones and nasty ones.
#pragma once

#include <vector>

#include <rsh/rsh_types.h>

#include "support/mesh.hpp"

namespace test {

struct Rays {
    std::vector<rsh_ray> rays;
    uint32_t width = 0;
    uint32_t height = 1;               // 1: a list
    std::vector<uint32_t> skip = {};   // a triangle per ray; empty: none for all
    std::vector<uint32_t> masks = {};  // of the meshes that rays hit; empty: all
};

rsh_ray make_ray(Float3 origin, Float3 direction, float tmin = 0.0f,
                 float tmax = std::numeric_limits<float>::infinity());

inline Float3 origin(const rsh_ray& r) {
    return {r.origin_tmin.s[0], r.origin_tmin.s[1], r.origin_tmin.s[2]};
}
inline Float3 direction(const rsh_ray& r) {
    return {r.direction_tmax.s[0], r.direction_tmax.s[1], r.direction_tmax.s[2]};
}

// As rsh_types.h defines it.
bool is_active(const rsh_ray& ray);

rsh_ray inactive_ray();

// From a pinhole at `eye` towards the cube around `at` with the given half-width.
Rays pinhole_rays(uint32_t width, uint32_t height, Float3 eye = {0.3f, 0.2f, 3.0f},
                  Float3 at = {}, float half = 1.2f);

// Nothing in common: origins in a cube, directions anywhere.
Rays random_rays(Random& random, uint32_t width, uint32_t height, float half = 2.0f);

// Mirrored off a bumpy sphere: coherent, wider than 90 degrees as a whole, a third inactive.
Rays reflected_rays(Random& random, uint32_t width, uint32_t height);

// Along the axes, with +0 and -0 components, many through exact grid vertices and edges.
Rays axis_rays(Random& random, uint32_t width, uint32_t height);

// d and -d side by side, from the same and from different origins.
Rays antiparallel_rays(Random& random, uint32_t width, uint32_t height);

// All the same ray.
Rays coincident_rays(uint32_t width, uint32_t height);

// Directions over `degrees` of arc from one origin: 90, 180 and beyond.
Rays fan_rays(uint32_t width, uint32_t height, float degrees);

// From all around to one point, where t = 1: shadow rays of a point light at `light`. Some end
// before it, a few run on behind it.
Rays converging_rays(Random& random, uint32_t width, uint32_t height, Float3 light);

// Directions so long, both ways, that every t underflows.
Rays long_rays(uint32_t width, uint32_t height);

// A list of rays along +z whose first ones start so far apart that their distance overflows.
// A list of rays from `distance` away, each through a corner of a triangle: where the scene's
// coordinates are small, the rays' own decide how much room a box must leave.
Rays rays_from_afar(Random& random, const Mesh& mesh, uint32_t count, float distance);
Rays far_apart_rays(uint32_t count);

// Inactive in every way there is, between active ones; short and empty intervals, denormals.
Rays invalid_rays(Random& random, uint32_t width, uint32_t height);

// In or nearly in the planes of the mesh's triangles.
Rays grazing_rays(Random& random, const Mesh& mesh, uint32_t width, uint32_t height);

// A vertex, or a rounded point of an edge, of a valid triangle.
Float3 point_on_edge(Random& random, const Mesh& mesh);

// At such points, from outside.
Rays rays_at_edges(Random& random, const Mesh& mesh, uint32_t width, uint32_t height);

// From points of the mesh, a few ulp off, most of them near edges and corners, into all
// directions; `skip` names the triangle, now and then another one or none.
Rays leaving_rays(Random& random, const Mesh& mesh, uint32_t width, uint32_t height);

Rays scaled(Rays rays, float scale, Float3 offset = {});

}  // namespace test
