// gltf_nodes.cpp - parents, their order, and inverse bind matrices.
#include "import/gltf/gltf_nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace render {
namespace {

[[noreturn]] void fail(const GltfDocument& document, const std::string& message) {
    throw std::runtime_error(document.location + ": " + message);
}

glm::dvec3 vector_or(const std::vector<double>& v, glm::dvec3 otherwise) {
    return v.size() == 3 ? glm::dvec3(v[0], v[1], v[2]) : otherwise;
}

// Columns, as glTF and glm have them.
glm::dmat4 matrix_of(const double* numbers) {
    glm::dmat4 matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) matrix[column][row] = numbers[4 * column + row];
    return matrix;
}

GltfNode node_of(const tinygltf::Node& node) {
    GltfNode n;
    n.translation = vector_or(node.translation, n.translation);
    n.scale = vector_or(node.scale, n.scale);
    if (node.rotation.size() == 4)
        n.rotation = glm::normalize(
            glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
    if (node.matrix.size() == 16) n.matrix = matrix_of(node.matrix.data());
    n.weights.assign(node.weights.begin(), node.weights.end());
    return n;
}

void set_parents(const GltfDocument& document, GltfScene& scene) {
    for (size_t i = 0; i < scene.nodes.size(); ++i)
        for (size_t k = 0; k < document.model.nodes[i].children.size(); ++k) {
            const auto child = static_cast<size_t>(document.model.nodes[i].children[k]);
            uint32_t& parent = scene.nodes[child].parent;
            if (parent != kNoGltfNode)
                fail(document, fmt::format("nodes[{}].children[{}]: is {}, which is a child of "
                                           "nodes[{}] already; one parent is allowed",
                                           i, k, child, parent));
            parent = static_cast<uint32_t>(i);
        }
}

// Roots, their children, and so on. Nodes that are their own ancestors have no root above them.
void set_order(const GltfDocument& document, GltfScene& scene) {
    for (size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].parent == kNoGltfNode)
            scene.order.push_back(static_cast<uint32_t>(i));
    for (size_t next = 0; next < scene.order.size(); ++next)
        for (const int child : document.model.nodes[scene.order[next]].children)
            scene.order.push_back(static_cast<uint32_t>(child));
    if (scene.order.size() == scene.nodes.size()) return;
    std::vector<bool> is_known(scene.nodes.size());
    for (const uint32_t node : scene.order) is_known[node] = true;
    for (size_t i = 0; i < is_known.size(); ++i)
        if (!is_known[i])
            fail(document, fmt::format("nodes[{}]: its ancestors are a circle, must end in a "
                                       "node that is no child",
                                       i));
}

std::vector<glm::dmat4> inverse_binds(const GltfDocument& document, const tinygltf::Skin& skin,
                                      const std::string& where) {
    std::vector<glm::dmat4> matrices(skin.joints.size(), glm::dmat4(1.0));
    if (skin.inverseBindMatrices < 0) return matrices;
    const GltfAccessors accessors(document);
    if (const size_t count = accessors.count(skin.inverseBindMatrices); count < matrices.size())
        accessors.fail(where, fmt::format("accessors[{}] has {} matrices, must have one for "
                                          "each of {} joints",
                                          skin.inverseBindMatrices, count, matrices.size()));
    const auto floats = accessors.floats(skin.inverseBindMatrices, TINYGLTF_TYPE_MAT4,
                                         GltfNumbers::floats, where);
    const std::vector<double> numbers(floats.begin(), floats.end());
    for (size_t i = 0; i < matrices.size(); ++i) matrices[i] = matrix_of(&numbers[16 * i]);
    return matrices;
}

}  // namespace

void read_nodes(const GltfDocument& document, GltfScene& scene) {
    for (const tinygltf::Node& node : document.model.nodes)
        scene.nodes.push_back(node_of(node));
    set_parents(document, scene);
    set_order(document, scene);
}

std::vector<bool> nodes_of_scene(const GltfDocument& document, const GltfScene& scene) {
    const tinygltf::Model& model = document.model;
    std::vector<bool> is_in(scene.nodes.size(), model.scenes.empty());
    if (model.scenes.empty()) return is_in;
    const auto chosen = static_cast<size_t>(std::max(model.defaultScene, 0));
    for (const int root : model.scenes[chosen].nodes) is_in[static_cast<size_t>(root)] = true;
    for (const uint32_t node : scene.order) {
        const uint32_t parent = scene.nodes[node].parent;
        if (parent != kNoGltfNode && is_in[parent]) is_in[node] = true;
    }
    return is_in;
}

void read_skins(const GltfDocument& document, GltfScene& scene) {
    for (size_t i = 0; i < document.model.skins.size(); ++i) {
        const tinygltf::Skin& skin = document.model.skins[i];
        scene.skins.push_back(
            {{skin.joints.begin(), skin.joints.end()},
             inverse_binds(document, skin, fmt::format("skins[{}].inverseBindMatrices", i))});
    }
}

}  // namespace render
