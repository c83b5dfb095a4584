// gltf_pose.hpp - the nodes of a GltfScene at one time, and its vertices there.
#pragma once

#include "import/gltf/gltf_scene.hpp"

namespace render {

struct GltfPose {
    std::vector<glm::dmat4> matrices;          // of nodes, into the file's world
    std::vector<std::vector<double>> weights;  // of nodes
};

GltfPose pose_at(const GltfScene& scene, double time);

// Of a vertex with such a normal; a zero normal (flat) stays zero.
glm::vec3 placed_normal(const glm::dmat4& matrix, glm::dvec3 normal);

// Whether the triangles of a placement are wound the other way round: a node mirrors them. Joints
// never do, whatever their matrices.
bool is_mirrored(const GltfPlacement& placement, const GltfPose& pose);

// Writes the placement's vertices into positions and, unless there are none, normals.
void place_vertices(const GltfScene& scene, const GltfPlacement& placement,
                    const GltfPose& pose, Mesh& mesh);

}  // namespace render
