// normals.cpp - sums over triangles.
#include "model/normals.hpp"

#include <cmath>

namespace render {

std::vector<glm::vec3> smooth_normals(const Mesh& mesh, const std::vector<uint32_t>& groups) {
    const auto group = [&](size_t vertex) { return groups.empty() ? vertex : groups[vertex]; };
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const glm::dvec3 twice_area = glm::cross(b - a, c - a);
        for (int corner = 0; corner < 3; ++corner) sums[group(t[corner])] += twice_area;
    }
    std::vector<glm::vec3> normals(sums.size(), glm::vec3(0.0f));
    for (size_t i = 0; i < normals.size(); ++i) {
        const glm::dvec3 sum = sums[group(i)];
        const double length = glm::length(sum);
        if (length > 0.0 && std::isfinite(length)) normals[i] = glm::vec3(sum / length);
    }
    return normals;
}

}  // namespace render
