// diffuse.cpp - hash, direction, origin off the surface.
#include "frame/diffuse.hpp"

#include <cmath>

namespace bench {
namespace {

// Wellons' lowbias32: every bit of the input changes each bit of the result with probability
// 1/2 (github.com/skeeto/hash-prospector, public domain).
uint32_t hash(uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

// In [0, 1).
float fraction(uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

// A point on the unit sphere plus the normal points with the cosine's distribution (the sphere
// around the normal's tip touches the surface: Lambert's law).
glm::vec3 cosine_direction(glm::vec3 normal, uint32_t pixel) {
    const float z = 1.0f - 2.0f * fraction(hash(2 * pixel));
    const float angle = 6.2831853f * fraction(hash(2 * pixel + 1));
    const float r = std::sqrt(1.0f - z * z);
    const glm::vec3 sum = normal + glm::vec3(r * std::cos(angle), r * std::sin(angle), z);
    const float length = glm::length(sum);
    return length > 1e-3f ? sum / length : normal;
}

constexpr rsh_ray kInactive = {{{0, 0, 0, 0}}, {{0, 0, 0, -1}}};

rsh_ray diffuse_ray(const glm::vec3 (&corner)[3], const rsh_hit& hit, const rsh_ray& ray,
                    uint32_t pixel) {
    const glm::vec3 u = corner[1] - corner[0], v = corner[2] - corner[0];
    const glm::vec3 way(ray.direction_tmax.s[0], ray.direction_tmax.s[1],
                        ray.direction_tmax.s[2]);
    glm::vec3 normal = glm::cross(u, v);
    const float area = glm::length(normal);
    if (!(area > 0.0f)) return kInactive;
    normal *= (glm::dot(normal, way) > 0.0f ? -1.0f : 1.0f) / area;
    const glm::vec3 point = corner[0] + hit.u * u + hit.v * v;
    const float size = std::sqrt(area) + glm::length(point);
    const glm::vec3 origin = point + 1e-5f * size * normal;
    const glm::vec3 direction = cosine_direction(normal, pixel);
    return {{{origin.x, origin.y, origin.z, 0.0f}},
            {{direction.x, direction.y, direction.z, INFINITY}}};
}

}  // namespace

void make_diffuse(const std::vector<glm::vec3>& positions,
                  const std::vector<glm::uvec3>& triangles, const std::vector<rsh_hit>& hits,
                  std::vector<rsh_ray>& rays) {
    for (size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].primitive == RSH_NO_HIT) {
            rays[i] = kInactive;
            continue;
        }
        const glm::uvec3 t = triangles[hits[i].primitive];
        const glm::vec3 corner[3] = {positions[t.x], positions[t.y], positions[t.z]};
        rays[i] = diffuse_ray(corner, hits[i], rays[i], static_cast<uint32_t>(i));
    }
}

}  // namespace bench
