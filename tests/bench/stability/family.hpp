// family.hpp - the families of scenes and rays on which an intersector may lose a hit or invent
// one. A family makes both from random numbers; it traces and judges nothing.
#pragma once

#include <optional>
#include <vector>

#include "stability/spawned/spawning.hpp"
#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace bench::stability {

struct Scene {
    test::Mesh mesh;
    test::Rays rays;             // in screen order, a square
    bool is_converging = false;  // t = 1 is one point for all rays
    // Vertices of frames before this one, over which bounds are kept; empty: they are made anew.
    std::vector<std::vector<test::Float3>> earlier = {};
    // Then those rays only make others, which are traced: see spawned/spawn.hpp.
    std::optional<Spawning> spawning = {};
};

struct Extent {
    uint32_t side;       // of the square of rays
    uint32_t triangles;  // about
};

enum class Kind {
    kRandom,   // hardly a ray passes within rounding of an edge
    kAimed,    // at edges, corners, planes: often both answers are right
    kLattice,  // in integers, where only one answer is right
    kClosed,   // aimed, from inside of a closed mesh: a ray without a hit has leaked
    kThrough,  // aimed, from outside right through closed meshes
    kSpawned,  // of closed meshes: a ray that begins inside and has no hit has leaked
};

struct Family {
    const char* name;
    Kind kind;
    Scene (*make)(test::Random& random, Extent extent);
};

// A row in the table of each group's file.
std::vector<Family> shape_families();   // of triangles
std::vector<Family> bundle_families();  // of rays
std::vector<Family> bound_families();   // of what lies beside bounds
std::vector<Family> magnitude_families();
std::vector<Family> lattice_families();
std::vector<Family> frame_families();    // of what moved
std::vector<Family> spawned_families();  // of rays that rsh_spawn makes

inline std::vector<Family> all_families() {
    std::vector<Family> all;
    for (const auto& group :
         {shape_families(), bundle_families(), bound_families(), magnitude_families(),
          lattice_families(), frame_families(), spawned_families()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

}  // namespace bench::stability
