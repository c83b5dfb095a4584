// gltf_pose.cpp - curves -> matrices; morph targets, then skins or nodes (glTF 2.0, 3.7).
#include "import/gltf/gltf_pose.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace render {
namespace {

void apply(const GltfCurve& curve, double time, GltfNode& node, std::vector<double>& weights) {
    const std::vector<double> v = value_at(curve, time);
    switch (curve.path) {
        case GltfPath::translation:
            node.translation = {v[0], v[1], v[2]};
            break;
        case GltfPath::rotation:
            node.rotation = glm::dquat(v[3], v[0], v[1], v[2]);
            break;
        case GltfPath::scale:
            node.scale = {v[0], v[1], v[2]};
            break;
        case GltfPath::weights:
            weights = v;
            break;
    }
}

glm::dmat4 own_matrix(const GltfNode& node) {
    if (node.matrix) return *node.matrix;
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), node.translation);
    return glm::scale(moved * glm::mat4_cast(node.rotation), node.scale);
}

std::vector<glm::dmat4> joint_matrices(const GltfSkin& skin, const GltfPose& pose) {
    std::vector<glm::dmat4> matrices;
    for (size_t i = 0; i < skin.joints.size(); ++i)
        matrices.push_back(pose.matrices[skin.joints[i]] * skin.inverse_binds[i]);
    return matrices;
}

glm::dmat4 blended(const GltfPrimitive& p, size_t vertex,
                   const std::vector<glm::dmat4>& joints) {
    glm::dmat4 sum(0.0);
    for (size_t i = vertex * p.influences; i < (vertex + 1) * p.influences; ++i)
        if (p.joint_weights[i] != 0.0f) sum += joints[p.joints[i]] * double{p.joint_weights[i]};
    return sum;
}

glm::dvec3 morphed(const std::vector<glm::vec3>& base, size_t vertex, const GltfPrimitive& p,
                   std::vector<glm::vec3> GltfTarget::*member,
                   const std::vector<double>& weights) {
    glm::dvec3 sum = base[vertex];
    for (size_t i = 0; i < p.targets.size(); ++i) {
        const std::vector<glm::vec3>& added = p.targets[i].*member;
        if (!added.empty()) sum += glm::dvec3(added[vertex]) * weights[i];
    }
    return sum;
}

}  // namespace

GltfPose pose_at(const GltfScene& scene, double time) {
    std::vector<GltfNode> nodes = scene.nodes;
    GltfPose pose;
    for (const GltfNode& node : nodes)
        pose.weights.emplace_back(node.weights.begin(), node.weights.end());
    for (const GltfCurve& curve : scene.curves)
        apply(curve, time, nodes[curve.node], pose.weights[curve.node]);
    pose.matrices.resize(nodes.size());
    for (const uint32_t node : scene.order) {
        const uint32_t parent = nodes[node].parent;
        const glm::dmat4 own = own_matrix(nodes[node]);
        pose.matrices[node] = parent == kNoGltfNode ? own : pose.matrices[parent] * own;
    }
    return pose;
}

glm::vec3 placed_normal(const glm::dmat4& matrix, glm::dvec3 normal) {
    const glm::dmat3 m(matrix);
    // The cofactor matrix is the inverse transpose times the determinant, whose sign counts.
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    const glm::dvec3 placed = cofactors * normal * (glm::determinant(m) < 0.0 ? -1.0 : 1.0);
    const double length = glm::length(placed);
    return length > 0.0 ? glm::vec3(placed / length) : glm::vec3(0.0f);
}

bool is_mirrored(const GltfPlacement& placement, const GltfPose& pose) {
    return placement.skin == kNoGltfSkin &&
           glm::determinant(glm::dmat3(pose.matrices[placement.node])) < 0.0;
}

void place_vertices(const GltfScene& scene, const GltfPlacement& placement,
                    const GltfPose& pose, Mesh& mesh) {
    const GltfPrimitive& p = scene.primitives[placement.primitive];
    const std::vector<double>& weights = pose.weights[placement.node];
    const bool has_skin = placement.skin != kNoGltfSkin;
    const std::vector<glm::dmat4> joints =
        has_skin ? joint_matrices(scene.skins[placement.skin], pose)
                 : std::vector<glm::dmat4>();
    for (size_t i = 0; i < p.positions.size(); ++i) {
        const glm::dmat4 matrix =
            has_skin ? blended(p, i, joints) : pose.matrices[placement.node];
        const size_t vertex = placement.first_vertex + i;
        mesh.positions[vertex] = glm::dvec3(
            matrix *
            glm::dvec4(morphed(p.positions, i, p, &GltfTarget::positions, weights), 1.0));
        if (!p.normals.empty())
            mesh.normals[vertex] =
                placed_normal(matrix, morphed(p.normals, i, p, &GltfTarget::normals, weights));
    }
}

}  // namespace render
