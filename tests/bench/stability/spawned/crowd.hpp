// crowd.hpp - closed bodies beside each other in one mesh, and rays that hit them where it is hard
// to leave.
#pragma once

#include "stability/family.hpp"
#include "support/bodies.hpp"

namespace bench::stability {

// Where a crowd stands: `offset` is in sizes of a body.
struct Place {
    double scale = 1;
    test::Double3 offset = {};
};

struct Crowd {
    test::Mesh mesh;
    std::vector<test::Mesh> bodies;  // the same, one by one
    std::vector<test::Placement> places;
    std::vector<uint32_t> body_of;  // per triangle of `mesh`
};

// The bodies in turn until there are about so many triangles, each turned by chance. The first one
// stands at the offset itself.
Crowd make_crowd(test::Random& random, const std::vector<test::Body>& bodies,
                 uint32_t triangles, const Place& place = {});

// A square, of test::rays_at_body at each body.
test::Rays rays_at_crowd(test::Random& random, const Crowd& crowd, uint32_t side);

}  // namespace bench::stability
