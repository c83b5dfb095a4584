// aff_scene.hpp - an AFF scene as its files say it, before a time is chosen. Plain data.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "import/bart/aff_curve.hpp"
#include "model/model.hpp"

namespace render {

// A transform; its parent has a lower number. nodes[0] is the world.
struct AffNode {
    size_t parent = 0;
    glm::dmat4 matrix{1.0};
    std::string track;  // of an animated transform, which has no matrix; else empty
};

// A triangle with a position and a normal of each corner per key, linear between keys.
struct AffMorph {
    uint32_t first_vertex = 0;
    std::vector<double> times;
    std::vector<std::array<glm::vec3, 6>> keys;  // position, normal, position, ...
};

struct AffLight {
    Light light;
    size_t node = 0;
    std::string track;  // of an animated light; else empty
};

// The name of the keys that move the camera.
constexpr const char* kCameraKeys = "camera";

struct AffScene {
    Mesh mesh;  // every vertex in the coordinates of its node
    std::vector<size_t> vertex_nodes;
    std::vector<AffNode> nodes{AffNode{}};
    std::vector<AffMorph> morphs;
    std::vector<AffLight> lights;
    std::vector<Material> materials;
    std::map<std::string, Track> tracks;
    std::optional<Camera> camera;
    std::optional<glm::vec3> background;
    glm::vec3 ambient{1.0f};
    double start = 0.0, end = 0.0;
    int frames = 1;
    std::vector<std::string> warnings;
};

// Throws LoadError.
AffScene parse_aff(const std::string& path);

}  // namespace render
