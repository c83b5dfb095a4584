// view_fit.cpp - default camera from the bounding box, default light from the camera.
#include "model/view_fit.hpp"

#include <cmath>

namespace render {
namespace {

bool is_finite(glm::vec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

Camera camera_that_fits(const Mesh& mesh) {
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 p = mesh.positions[triangle[corner]];
            if (!is_finite(p)) continue;
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    Camera camera;
    if (!(low.x <= high.x)) return camera;  // nothing finite to look at
    // Half the diagonal is the radius of a sphere around the box; from radius / sin(half the
    // field of view) that sphere just fits.
    const float radius = std::max(0.5f * glm::distance(low, high), 1e-20f);
    const float half_view = glm::radians(0.5f * camera.vertical_degrees);
    const float distance = radius / std::sin(half_view);
    camera.at = 0.5f * low + 0.5f * high;
    camera.eye = camera.at + distance * glm::normalize(glm::vec3(0.55f, 0.35f, 1.0f));
    camera.near = 1e-3f * radius;
    return camera;
}

Light light_over_shoulder(const Camera& camera) {
    const glm::vec3 forward = glm::normalize(camera.at - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    Light light;
    light.kind = RSH_LIGHT_DIRECTIONAL;
    light.direction = forward + 0.5f * right - 0.8f * glm::normalize(camera.up);
    return light;
}

}  // namespace render
