// surfaces.cpp - planes, boxes, balls and turned shapes as patches.
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

#include "generate/furniture.hpp"

namespace render {
namespace {

// Curved surfaces get this many times the columns and rows per length of flat ones.
constexpr float kCurvedDetail = 6.0f;

glm::vec2 spline(const std::vector<glm::vec2>& points, float v) {
    const int last = static_cast<int>(points.size()) - 1;
    const float position = v * last;
    const int i = std::min(static_cast<int>(position), last - 1);
    const float u = position - i;
    const glm::vec2 a = points[std::max(i - 1, 0)], b = points[i];
    const glm::vec2 c = points[i + 1], d = points[std::min(i + 2, last)];
    return 0.5f * (2.0f * b + u * (c - a) + u * u * (2.0f * a - 5.0f * b + 4.0f * c - d) +
                   u * u * u * (3.0f * b - a - 3.0f * c + d));
}

float length_of(const std::vector<glm::vec2>& points) {
    float length = 0.0f;
    for (size_t i = 1; i < points.size(); ++i)
        length += glm::distance(points[i - 1], points[i]);
    return length;
}

// Outline running upwards: its outer normal is the tangent turned by -90 degrees.
glm::vec2 outline_normal(const std::vector<glm::vec2>& points, float v) {
    constexpr float kStep = 1e-3f;
    const glm::vec2 tangent =
        spline(points, std::min(v + kStep, 1.0f)) - spline(points, std::max(v - kStep, 0.0f));
    return glm::normalize(glm::vec2(tangent.y, -tangent.x));
}

// Around the vertical axis; u = 1 is exactly u = 0, so that the seam is closed.
glm::vec3 around(float u, float radius, float height) {
    const float angle = u < 1.0f ? u * glm::two_pi<float>() : 0.0f;
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

}  // namespace

void add_plane(Patches& patches, glm::vec3 corner, glm::vec3 along_u, glm::vec3 along_v,
               uint32_t material) {
    Patch patch;
    const glm::vec3 normal = glm::normalize(glm::cross(along_u, along_v));
    patch.at = [=](float u, float v) {
        return SurfacePoint{corner + u * along_u + v * along_v, normal};
    };
    patch.material = material;
    patch.size = {glm::length(along_u), glm::length(along_v)};
    patches.push_back(patch);
}

void add_box(Patches& patches, glm::vec3 low, glm::vec3 high, uint32_t material) {
    const glm::vec3 d = high - low;
    const glm::vec3 x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
    add_plane(patches, low, z, y, material);
    add_plane(patches, low, x, z, material);
    add_plane(patches, low, y, x, material);
    add_plane(patches, high, -y, -z, material);
    add_plane(patches, high, -z, -x, material);
    add_plane(patches, high, -x, -y, material);
}

void add_ball(Patches& patches, glm::vec3 centre, float radius, uint32_t material) {
    Patch patch;
    patch.at = [=](float u, float v) {
        const float angle = (v - 0.5f) * glm::pi<float>();
        const bool is_pole = v == 0.0f || v == 1.0f;
        const glm::vec3 normal =
            is_pole ? glm::vec3(0, 2 * v - 1, 0) : around(u, std::cos(angle), std::sin(angle));
        return SurfacePoint{centre + radius * normal, normal};
    };
    patch.material = material;
    patch.size = {glm::two_pi<float>() * radius, glm::pi<float>() * radius};
    patch.detail = kCurvedDetail;
    patch.least_columns = 6;
    patch.least_rows = 3;
    patch.starts_at_pole = patch.ends_at_pole = true;
    patches.push_back(patch);
}

void add_turned(Patches& patches, glm::vec3 foot, const std::vector<glm::vec2>& outline,
                uint32_t material) {
    Patch patch;
    patch.at = [=](float u, float v) {
        const glm::vec2 point = spline(outline, v);
        const glm::vec2 normal = outline_normal(outline, v);
        return SurfacePoint{foot + around(u, std::max(point.x, 0.0f), point.y),
                            around(u, normal.x, normal.y)};
    };
    float widest = 0.0f;
    for (const glm::vec2& point : outline) widest = std::max(widest, point.x);
    patch.material = material;
    patch.size = {glm::two_pi<float>() * widest, length_of(outline)};
    patch.detail = kCurvedDetail;
    patch.least_columns = 5;
    patch.least_rows = 3;
    patch.starts_at_pole = outline.front().x == 0.0f;
    patch.ends_at_pole = outline.back().x == 0.0f;
    patches.push_back(patch);
}

}  // namespace render
