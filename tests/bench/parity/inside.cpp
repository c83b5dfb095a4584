#include "parity/inside.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/crossings/windings.hpp"

namespace bench::parity {
namespace {

using test::Double3;
using test::Float3;

// rsh.h, rsh_traverse, Errors: of the farthest component of a corner, seen from the ray's origin.
constexpr double kHitError = 47 * 0x1p-24;
// Of a turn: the sum of solid angles in double precision is no farther off a whole one, unless the
// point is on the surface.
constexpr double kWholeTurn = 1e-6;

constexpr int8_t kOpen = 2;  // else 0 or 1

double farthest_corner(const test::Mesh& mesh, Float3 point) {
    double farthest = 0;
    for (const Float3& v : mesh.vertices)
        farthest = std::max(farthest, max_norm(Double3(v) - Double3(point)));
    return farthest;
}

}  // namespace

Judge::Judge(const test::Mesh& mesh, const test::Rays& rays) : mesh_(mesh), rays_(rays) {
    std::vector<Float3> points;
    for (const rsh_ray& ray : rays.rays) points.push_back(test::origin(ray));
    for (const oracle::Winding& w : oracle::windings(mesh, points))
        turns_.push_back(w.off < kWholeTurn ? int8_t(w.turns % 2 != 0) : kOpen);
}

bool Judge::is_near(size_t ray) const {
    const Float3 point = test::origin(rays_.rays[ray]);
    return oracle::distance_to_surface(mesh_, point) <=
           kHitError * farthest_corner(mesh_, point);
}

Inside Judge::compare(const std::vector<cl_uint>& counts) const {
    Inside all;
    all.points = counts.size();
    for (size_t i = 0; i < counts.size(); ++i) {
        all.inside += counts[i] % 2;
        if (int8_t(counts[i] % 2) == turns_[i]) continue;
        if (is_near(i)) {
            ++all.near;
            continue;
        }
        const Float3 at = test::origin(rays_.rays[i]);
        if (all.wrong++ == 0)
            all.why = fmt::format(
                "point {} at {} {} {}: its ray crosses {} triangles, by solid angles it is {}",
                i, at.x, at.y, at.z, counts[i],
                turns_[i] == kOpen ? "on the surface, which is not near"
                : turns_[i]        ? "inside"
                                   : "outside");
    }
    return all;
}

}  // namespace bench::parity
