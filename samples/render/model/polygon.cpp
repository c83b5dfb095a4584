// polygon.cpp - corners -> triangles: a fan, or ears in the plane that faces the polygon most.
// Handles neither holes (other than as a doubled edge) nor self-intersection in any special
// way.
#include "model/polygon.hpp"

#include <cmath>

#include "model/ear_clipper.hpp"
#include "model/point_tree.hpp"

namespace render {
namespace {

// Newell's normal: the sum of the cross products of all edges, exact for planar polygons and
// an average for others (Sutherland et al. 1974).
glm::dvec3 newell_normal(const std::vector<glm::dvec3>& corners) {
    glm::dvec3 normal(0.0);
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i] - corners[0];
        const glm::dvec3 b = corners[(i + 1) % corners.size()] - corners[0];
        normal += glm::cross(a, b);
    }
    return normal;
}

// Drops the axis in which the normal is longest, such that the polygon turns to the left.
std::vector<glm::dvec2> flatten(const std::vector<glm::dvec3>& corners, glm::dvec3 normal) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& c : corners) flat.emplace_back(sign * c[u], c[v]);
    return flat;
}

bool is_convex(const std::vector<glm::dvec2>& flat) {
    for (size_t i = 0, n = flat.size(); i < n; ++i)
        if (turn(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0.0) return false;
    return true;
}

std::vector<glm::uvec3> fan(size_t corners) {
    std::vector<glm::uvec3> triangles;
    for (uint32_t i = 2; i < corners; ++i) triangles.push_back({0u, i - 1, i});
    return triangles;
}

}  // namespace

std::vector<glm::uvec3> triangulate(const std::vector<glm::dvec3>& corners) {
    if (corners.size() < 4) return fan(corners.size());
    const glm::dvec3 normal = newell_normal(corners);
    const double length = glm::length(normal);
    if (!std::isfinite(length) || length == 0.0) return fan(corners.size());
    const std::vector<glm::dvec2> flat = flatten(corners, normal);
    if (is_convex(flat)) return fan(corners.size());
    return clip_ears(flat);
}

}  // namespace render
