// separated.cpp - signs in long double: far finer than 2^-42, to which the library may decide.
#include "oracle/leaving/separated.hpp"

namespace oracle {
namespace {

using test::Corners;
using test::Long3;

// Twice and more what kernels/mesh/leaving.h leaves open, of the terms of a product.
constexpr long double kAlong = 0x1p-20L, kAcross = 0x1p-40L, kInPlane = 0x1p-50L;

long double size_of_terms(Long3 a, Long3 b) {
    return std::fabs(a.x * b.x) + std::fabs(a.y * b.y) + std::fabs(a.z * b.z);
}

// Whether it does, with corners in the plane or without.
bool separates(const rsh_ray& ray, const Corners& plane, const Corners& hit, bool in_plane) {
    const Long3 origin(test::origin(ray)), direction(test::direction(ray)), a(plane[0]);
    Long3 normal = cross(Long3(plane[1]) - a, Long3(plane[2]) - a);
    const long double along = dot(normal, direction);
    if (!(std::fabs(along) > kAlong * size_of_terms(normal, direction))) return false;
    if (along < 0) normal = -1.0L * normal;
    for (const test::Float3 corner : hit) {
        const Long3 way = Long3(corner) - origin;
        const long double height = dot(normal, way), size = size_of_terms(normal, way);
        if (in_plane ? height > kInPlane * size : height >= -kAcross * size) return false;
    }
    return true;
}

}  // namespace

bool is_separated(const rsh_ray& ray, const Corners& left, const Corners& hit) {
    return separates(ray, hit, hit, false) || separates(ray, left, hit, true);
}

}  // namespace oracle
