// parity_rays.hpp - points around a mesh, each with the direction in which crossings are counted.
#pragma once

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace bench::parity {

enum class Points {
    kRandom,  // in the box around the mesh, any direction
    kChosen  // a third each: along an axis through a vertex, the same through an edge, and in the
             // plane of a triangle along one of its edges
};
const char* name_of(Points points);

// To infinity, as a list.
test::Rays rays_from(test::Random& random, const test::Mesh& mesh, Points points,
                     uint32_t count);

}  // namespace bench::parity
