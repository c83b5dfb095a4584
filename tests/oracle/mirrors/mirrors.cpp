// mirrors.cpp - products of a few vectors; doubles tell which triangles are worth 113
// bits.
#include "oracle/mirrors/mirrors.hpp"

namespace oracle {
namespace {

using test::Corners;
using test::Double3;

// The three signed volumes of the line through 0 along d with the edges have one sign, or come
// within `error` of it.
template <class T>
bool passes(const test::Vec3<T>& d, const test::Vec3<T> (&corner)[3], T error) {
    bool is_left = true, is_right = true;
    for (int k = 0; k < 3; ++k) {
        const T volume = dot(d, cross(corner[k], corner[(k + 1) % 3]));
        is_left &= volume >= -error;
        is_right &= volume <= error;
    }
    return is_left || is_right;
}

template <class T>
bool passes(const test::Vec3<T>& origin, const test::Vec3<T>& d, const Corners& triangle,
            T error) {
    using V = test::Vec3<T>;
    const V corner[3] = {V(triangle[0]) - origin, V(triangle[1]) - origin,
                         V(triangle[2]) - origin};
    return passes(d, corner, error);
}

// Rounding the ray and three products of vectors: some ulp of the largest of them.
double error_of_doubles(const Double3& origin, const Double3& d, const Corners& triangle) {
    const double size = max_norm(origin) + max_norm(Double3(triangle[0])) +
                        max_norm(Double3(triangle[1])) + max_norm(Double3(triangle[2]));
    return 1e-13 * max_norm(d) * size * size;
}

// Around the corners, with room for rounding.
Ball ball_around(const Corners& p) {
    const Double3 centre = (1.0 / 3) * (Double3(p[0]) + Double3(p[1]) + Double3(p[2]));
    double radius = 0;
    for (const test::Float3& corner : p)
        radius = std::fmax(radius, length(Double3(corner) - centre));
    return {centre, 1.001 * radius + 1e-12 * max_norm(centre)};
}

// False only where the line through the origin along d passes the ball by.
bool may_meet(const Ball& ball, const Double3& origin, const Double3& d) {
    const Double3 across = cross(ball.centre - origin, d);
    const double reach = ball.radius + 1e-12 * max_norm(origin);
    return dot(across, across) <= reach * reach * dot(d, d);
}

Quad3 normal_of(const Corners& p) {
    return cross(Quad3(p[1]) - Quad3(p[0]), Quad3(p[2]) - Quad3(p[0]));
}

Quad3 mirrored(const Quad3& d, const Quad3& n) {
    return d - (2 * dot(d, n) / dot(n, n)) * n;
}

Quad depth_of_plane(const MirrorRay& ray, const Corners& triangle) {
    const Quad3 n = normal_of(triangle);
    return dot(n, Quad3(triangle[0]) - ray.origin) / dot(n, ray.direction);
}

}  // namespace

Mirrors::Mirrors(const test::Mesh& mesh, const std::vector<test::Float3>& normals) {
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        Corners corners;
        if (!mesh.corners(i, &corners)) continue;
        triangles_.push_back(corners);
        balls_.push_back(ball_around(corners));
        if (normals.empty()) continue;
        const uint32_t* index = &mesh.indices[3 * i];
        normals_.push_back({normals[index[0]], normals[index[1]], normals[index[2]]});
    }
}

MirrorHit Mirrors::nearest(const MirrorRay& ray) const {
    const Double3 origin(ray.origin), direction(ray.direction);
    MirrorHit hit;
    Quad nearest = 0;
    for (uint32_t i = 0; i < triangles_.size(); ++i) {
        if (i == ray.skip || !may_meet(balls_[i], origin, direction)) continue;
        const Corners& triangle = triangles_[i];
        if (!passes(origin, direction, triangle, error_of_doubles(origin, direction, triangle)))
            continue;
        if (!passes(ray.origin, ray.direction, triangle, Quad(0))) continue;
        const Quad t = depth_of_plane(ray, triangle);
        if (t < 0 || (hit.triangle != RSH_NO_HIT && t >= nearest)) continue;
        nearest = t;
        hit = {i, ray.origin + t * ray.direction};
    }
    return hit;
}

Quad3 Mirrors::point_in_plane(const MirrorRay& ray, uint32_t triangle) const {
    return ray.origin + depth_of_plane(ray, triangles_[triangle]) * ray.direction;
}

Quad3 Mirrors::normal_at(const MirrorHit& hit) const {
    const Corners& p = triangles_[hit.triangle];
    const Quad3 plane = normal_of(p);
    if (normals_.empty()) return plane;
    const Quad3 from_v0 = hit.point - Quad3(p[0]);
    const Quad square = dot(plane, plane);
    const Quad u = dot(plane, cross(from_v0, Quad3(p[2]) - Quad3(p[0]))) / square;
    const Quad v = dot(plane, cross(Quad3(p[1]) - Quad3(p[0]), from_v0)) / square;
    const Corners& n = normals_[hit.triangle];
    return (1 - u - v) * Quad3(n[0]) + u * Quad3(n[1]) + v * Quad3(n[2]);
}

MirrorRay Mirrors::reflected(const MirrorRay& ray, const MirrorHit& hit) const {
    const Quad3 plane = plane_normal(hit.triangle);
    Quad3 direction = mirrored(ray.direction, normal_at(hit));
    const bool is_above = dot(ray.direction, plane) < 0;
    if ((dot(direction, plane) > 0) != is_above) direction = mirrored(direction, plane);
    return {hit.point, direction, hit.triangle};
}

Quad3 Mirrors::plane_normal(uint32_t triangle) const {
    return normal_of(triangles_[triangle]);
}

Quad3 Mirrors::normal_towards(const MirrorRay& leaving) const {
    const Quad3 normal = plane_normal(leaving.skip);
    return dot(normal, leaving.direction) < 0 ? Quad(-1) * normal : normal;
}

}  // namespace oracle
