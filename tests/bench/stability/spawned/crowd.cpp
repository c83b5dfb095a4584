#include "stability/spawned/crowd.hpp"

#include <algorithm>

namespace bench::stability {
namespace {

constexpr double kApart = 4;  // sizes of a body, which turned is 2 sqrt(3) wide
constexpr uint32_t kCells = 16;

// Place i of a lattice: next to each other, one after the other.
test::Double3 cell(uint32_t i) {
    return {kApart * double(i % kCells), kApart * double(i / kCells % kCells),
            kApart * double(i / kCells / kCells)};
}

void add(Crowd& crowd, const test::Body& body, const test::Placement& at) {
    const test::Mesh mesh = test::placed(body, at);
    const auto first = uint32_t(crowd.mesh.vertices.size());
    crowd.mesh.vertices.insert(crowd.mesh.vertices.end(), mesh.vertices.begin(),
                               mesh.vertices.end());
    for (const uint32_t index : mesh.indices) crowd.mesh.indices.push_back(first + index);
    crowd.body_of.resize(crowd.mesh.triangle_count(), uint32_t(crowd.bodies.size()));
    crowd.bodies.push_back(mesh);
    crowd.places.push_back(at);
}

}  // namespace

Crowd make_crowd(test::Random& random, const std::vector<test::Body>& bodies,
                 uint32_t triangles, const Place& place) {
    Crowd crowd;
    for (uint32_t i = 0; i == 0 || crowd.mesh.triangle_count() < triangles; ++i) {
        test::Placement at;
        at.scale = place.scale;
        at.offset = place.offset + cell(i);
        if (random.chance(0.5f)) at.turn = test::random_turn(random);
        add(crowd, bodies[i % bodies.size()], at);
    }
    return crowd;
}

test::Rays rays_at_crowd(test::Random& random, const Crowd& crowd, uint32_t side) {
    test::Rays rays = {{}, side, side};
    const uint32_t count = side * side;
    const auto bodies = uint32_t(crowd.bodies.size());
    for (uint32_t i = 0; i < bodies; ++i) {
        const uint32_t share = count / bodies + (i < count % bodies);
        const test::Rays some =
            test::rays_at_body(random, crowd.bodies[i], crowd.places[i], share);
        rays.rays.insert(rays.rays.end(), some.rays.begin(), some.rays.end());
    }
    return rays;
}

}  // namespace bench::stability
