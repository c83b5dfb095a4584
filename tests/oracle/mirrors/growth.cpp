// growth.cpp - a second ray beside the path, 2^-56 away; moved back to that distance at every
// bounce.
#include "oracle/mirrors/growth.hpp"

#include "oracle/mirrors/float_state.hpp"

namespace oracle {
namespace {

using test::Double3;

struct Offset {
    Quad3 origin, direction;
};

Offset difference(const MirrorRay& a, const MirrorRay& b) {
    return {a.origin - b.origin, a.direction - b.direction};
}

// Of the direction, only what turns it.
double size_of(const Offset& offset, const MirrorRay& ray, double unit) {
    const Double3 direction(ray.direction);
    const double turn = length(cross(Double3(offset.direction), direction));
    return length(
        Double3(length(Double3(offset.origin)) / unit, turn / dot(direction, direction), 0));
}

// Along the same triangles, also where the second ray would miss them.
Offset after_bounce(const Offset& before, double share, const Step& step,
                    const MirrorRay& after, const Mirrors& mirrors) {
    const Quad small = share;
    const MirrorRay beside = {step.ray.origin + small * before.origin,
                              step.ray.direction + small * before.direction, step.ray.skip};
    const uint32_t triangle = step.next.triangle;
    const MirrorHit hit = {triangle, mirrors.point_in_plane(beside, triangle)};
    const Offset offset = difference(mirrors.reflected(beside, hit), after);
    return {Quad(1 / share) * offset.origin, Quad(1 / share) * offset.direction};
}

}  // namespace

std::vector<double> growth_along(const Path& exact, const Mirrors& mirrors, double unit) {
    if (exact.empty()) return {};
    Offset offset = difference(rounded(exact[0].ray, {}), exact[0].ray);
    const double first = size_of(offset, exact[0].ray, unit);
    double size = first;
    std::vector<double> growth = {1};
    for (size_t k = 1; k < exact.size(); ++k) {
        offset = after_bounce(offset, 0x1p-56 / size, exact[k - 1], exact[k].ray, mirrors);
        size = size_of(offset, exact[k].ray, unit);
        growth.push_back(size / first);
    }
    return growth;
}

}  // namespace oracle
