// polygon.cpp - corners -> triangles: ear clipping in the plane that faces the polygon most.
// Handles neither holes (other than as a doubled edge) nor self-intersection in any special
// way.
#include "model/polygon.hpp"

#include <cmath>

namespace render {
namespace {

// Ear clipping is cubic in the worst case; a polygon of more corners becomes a fan.
constexpr size_t kMaxEarCorners = 2000;

// Newell's normal: the sum of the cross products of all edges, exact for planar polygons and
// an average for others (Sutherland et al. 1974).
glm::dvec3 newell_normal(const std::vector<glm::vec3>& corners) {
    glm::dvec3 normal(0.0);
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::dvec3(corners[i]) - glm::dvec3(corners[0]);
        const glm::dvec3 b =
            glm::dvec3(corners[(i + 1) % corners.size()]) - glm::dvec3(corners[0]);
        normal += glm::cross(a, b);
    }
    return normal;
}

// Drops the axis in which the normal is longest, such that the polygon turns to the left.
std::vector<glm::dvec2> flatten(const std::vector<glm::vec3>& corners, glm::dvec3 normal) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> flat;
    for (const glm::vec3& c : corners) flat.emplace_back(sign * c[u], c[v]);
    return flat;
}

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    const glm::dvec2 p = b - a, q = c - a;
    return p.x * q.y - p.y * q.x;
}

bool contains(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) {
    return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
           turn(c, a, p) >= 0.0;
}

class EarClipper {
public:
    explicit EarClipper(std::vector<glm::dvec2> flat) : flat_(std::move(flat)) {
        for (uint32_t i = 0; i < flat_.size(); ++i) left_.push_back(i);
    }

    std::vector<glm::uvec3> clip() {
        std::vector<glm::uvec3> triangles;
        while (left_.size() > 3) {
            const size_t ear = find_ear();
            triangles.push_back(corner(ear));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        triangles.push_back({left_[0], left_[1], left_[2]});
        return triangles;
    }

private:
    glm::uvec3 corner(size_t i) const {
        const size_t n = left_.size();
        return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
    }

    bool is_ear(size_t i) const {
        const glm::uvec3 t = corner(i);
        if (!(turn(flat_[t.x], flat_[t.y], flat_[t.z]) > 0.0)) return false;
        for (const uint32_t other : left_)
            if (contains(flat_[t.x], flat_[t.y], flat_[t.z], flat_[other])) return false;
        return true;
    }

    // A polygon that crosses itself may have no ear; then any corner goes.
    size_t find_ear() const {
        for (size_t i = 0; i < left_.size(); ++i)
            if (is_ear(i)) return i;
        return 1;
    }

    std::vector<glm::dvec2> flat_;
    std::vector<uint32_t> left_;
};

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

std::vector<glm::uvec3> triangulate(const std::vector<glm::vec3>& corners) {
    if (corners.size() < 4 || corners.size() > kMaxEarCorners) return fan(corners.size());
    const glm::dvec3 normal = newell_normal(corners);
    const double length = glm::length(normal);
    if (!std::isfinite(length) || length == 0.0) return fan(corners.size());
    std::vector<glm::dvec2> flat = flatten(corners, normal);
    if (is_convex(flat)) return fan(corners.size());
    return EarClipper(std::move(flat)).clip();
}

}  // namespace render
