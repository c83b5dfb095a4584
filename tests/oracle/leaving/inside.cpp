#include "oracle/leaving/inside.hpp"

#include "oracle/exact.hpp"
#include "support/random.hpp"

namespace oracle {
namespace {

using test::Corners;
using test::Float3;

enum class Crossing { kNone, kAhead, kOpen, kThrough };

// kOpen: the line meets an edge or runs along the plane. kThrough: the point is on the triangle.
Crossing crossing(Float3 point, Float3 direction, const Corners& c) {
    int above = 0, below = 0;
    for (size_t i = 0; i < 3; ++i) {
        const int side = side_of_edge(point, direction, c[i], c[(i + 1) % 3]);
        above += side > 0;
        below += side < 0;
    }
    if (above > 0 && below > 0) return Crossing::kNone;
    if (above + below < 3) return Crossing::kOpen;
    // The volumes have the sign of normal . direction.
    const int side = side_of_plane(point, c);
    if (side == 0) return Crossing::kThrough;
    return (above > 0) == (side > 0) ? Crossing::kNone : Crossing::kAhead;
}

}  // namespace

bool is_inside(const test::Mesh& mesh, Float3 point) {
    test::Random random(7);
    for (int attempt = 0; attempt < 100; ++attempt) {
        const Float3 direction = random.direction();
        bool inside = false, is_open = false;
        for (uint32_t i = 0; i < mesh.triangle_count() && !is_open; ++i) {
            Corners corners;
            if (!mesh.corners(i, &corners)) continue;
            const Crossing found = crossing(point, direction, corners);
            if (found == Crossing::kThrough) return false;
            is_open = found == Crossing::kOpen;
            inside ^= found == Crossing::kAhead;
        }
        if (!is_open) return inside;
    }
    return false;  // on an edge
}

}  // namespace oracle
