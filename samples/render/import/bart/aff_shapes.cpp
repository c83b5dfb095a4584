// aff_shapes.cpp - rings of vertices joined by bands of quads.
#include "import/bart/aff_shapes.hpp"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace render {
namespace {

// Joins the last two rings of kSides vertices; seen from outside counter-clockwise when the
// ring runs counter-clockwise around the direction from the first ring to the second.
void add_band(Shape& shape) {
    const auto upper = static_cast<uint32_t>(shape.positions.size()) - kSides;
    const uint32_t lower = upper - kSides;
    for (uint32_t i = 0; i < kSides; ++i) {
        const uint32_t j = (i + 1) % kSides;
        shape.triangles.push_back({lower + i, lower + j, upper + j});
        shape.triangles.push_back({lower + i, upper + j, upper + i});
    }
}

struct Ring {
    glm::dvec3 centre, normal_along;  // what all its normals have in common
    double radius = 0.0, normal_radius = 1.0;
};

void add_ring(Shape& shape, const Ring& ring, glm::dvec3 u, glm::dvec3 v) {
    for (uint32_t i = 0; i < kSides; ++i) {
        const double angle = glm::two_pi<double>() * i / kSides;
        const glm::dvec3 out = std::cos(angle) * u + std::sin(angle) * v;
        shape.positions.push_back(ring.centre + ring.radius * out);
        shape.normals.push_back(glm::normalize(ring.normal_radius * out + ring.normal_along));
    }
}

// Any unit vector across the unit vector `axis`.
glm::dvec3 across(glm::dvec3 axis) {
    const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, other));
}

}  // namespace

Shape make_cone(glm::dvec3 base, double base_radius, glm::dvec3 apex, double apex_radius) {
    const double height = glm::distance(base, apex);
    const glm::dvec3 axis = height > 0.0 ? (apex - base) / height : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = across(axis), v = glm::cross(axis, u);
    // The side runs (apex_radius - base_radius, height) in (radius, axis); across it lies
    // (height, base_radius - apex_radius).
    const bool is_flat = height == 0.0;
    const glm::dvec3 along = (is_flat ? 1.0 : base_radius - apex_radius) * axis;
    Shape shape;
    add_ring(shape, {base, along, base_radius, height}, u, v);
    add_ring(shape, {apex, along, apex_radius, height}, u, v);
    add_band(shape);
    return shape;
}

Shape make_sphere(glm::dvec3 centre, double radius) {
    const glm::dvec3 axis(0, 1, 0), u(0, 0, 1), v(1, 0, 0);
    constexpr uint32_t kBands = kSides / 2;
    Shape shape;
    for (uint32_t i = 0; i <= kBands; ++i) {
        const double angle = glm::pi<double>() * i / kBands;  // from the lower pole
        const double up = -std::cos(angle), out = std::sin(angle);
        add_ring(shape, {centre + radius * up * axis, up * axis, radius * out, out}, u, v);
        if (i > 0) add_band(shape);
    }
    return shape;
}

}  // namespace render
