// gltf_scene.hpp - a glTF file with one of its clips, as it is before a time is chosen. Plain data.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <optional>
#include <string>
#include <vector>

#include "import/gltf/gltf_curve.hpp"
#include "model/model.hpp"

namespace render {

constexpr uint32_t kNoGltfNode = 0xffffffffu, kNoGltfSkin = 0xffffffffu;

// A transform in that of its parent.
struct GltfNode {
    uint32_t parent = kNoGltfNode;
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
    std::optional<glm::dmat4> matrix;  // instead of the three
    std::vector<float> weights;        // of its mesh's morph targets
};

// What a morph target of weight 1 adds; empty: nothing.
struct GltfTarget {
    std::vector<glm::vec3> positions, normals;
};

// The triangles of one material in one mesh, in the coordinates of a node that places them.
struct GltfPrimitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;    // empty: flat
    std::vector<glm::vec2> texcoords;  // empty, or one per vertex
    std::vector<glm::uvec3> triangles;
    std::vector<GltfTarget> targets;
    // Of a skin, `influences` for each vertex; the weights of a vertex add up to 1.
    size_t influences = 0;
    std::vector<uint32_t> joints;
    std::vector<float> joint_weights;
    uint32_t material = 0;
};

// A primitive where a node places it: these vertices and triangles of the mesh.
struct GltfPlacement {
    size_t primitive = 0;
    uint32_t node = 0;
    uint32_t skin = kNoGltfSkin;  // joints place it, not the node
    size_t first_vertex = 0, first_triangle = 0;
};

struct GltfSkin {
    std::vector<uint32_t> joints;  // nodes
    std::vector<glm::dmat4> inverse_binds;
};

struct GltfLight {
    Light light;  // at the origin of its node, along -z
    uint32_t node = 0;
};

struct GltfCamera {
    Camera camera;  // likewise
    uint32_t node = 0;
};

struct GltfScene {
    std::vector<GltfNode> nodes;
    std::vector<uint32_t> order;  // of all nodes, parents before children
    std::vector<GltfPrimitive> primitives;
    std::vector<GltfPlacement> placements;
    std::vector<GltfSkin> skins;
    std::vector<GltfCurve> curves;  // of the clip; empty: nothing moves
    std::vector<GltfLight> lights;
    std::optional<GltfCamera> camera;
    std::vector<Material> materials;
    std::vector<std::string> warnings;
};

// `clip`: the name of an animation, or its number; empty: the first. `path` as in asset.hpp. Throws
// std::runtime_error.
GltfScene read_gltf(const std::string& path, const std::string& clip);

}  // namespace render
