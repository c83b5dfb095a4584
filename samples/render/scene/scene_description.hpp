// scene_description.hpp - what a scene file says, checked and with every file found, before any
// mesh is read. Plain data; README.md beside the scenes documents the format.
#pragma once

#include <glm/glm.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generate/room.hpp"
#include "model/model.hpp"
#include "scene/motion.hpp"
#include "scene/view/view_keys.hpp"

namespace render {

// The members of a material that a scene file sets; the others stay as the mesh has them.
struct MaterialChange {
    std::optional<glm::vec3> ambient, diffuse, specular, reflection, transmission, emission;
    std::optional<float> shininess, ior;
    std::optional<std::string> texture;
};

struct Stand {
    glm::vec3 at{0.0f};
    float height = 1.0f;
};

struct MeshEntry {
    std::string where;          // "scene.json: meshes[2]", the start of messages about it
    std::string file;           // empty: `room`
    std::string vertex_frames;  // positions per frame over the topology of `file`; empty: none
    RoomOptions room;
    bool is_smooth = false;         // make vertex normals, instead of the file's
    float crease_degrees = 180.0f;  // edges that are sharper stay so
    std::string clip;               // which animation of a glTF file; empty: its first
    bool repeats = false;           // an animation starts again after its end
    glm::dmat4 transform{1.0};
    std::optional<Stand> stand;
    std::vector<RigidKey> keys;
    MaterialChange material;                          // of every material, ...
    std::map<std::string, MaterialChange> materials;  // ... then of those named
};

struct Environment {
    glm::vec3 colour{0.0f};
    std::string image;  // empty: the plain colour
};

struct Interval {
    double start = 0.0;
    double end = 0.0;
};

struct SceneSettings {
    std::optional<glm::uvec2> size;
    std::optional<uint32_t> bounces;
    std::optional<float> min_weight;
    std::optional<uint32_t> cut;  // RSH_CUT_...
    std::optional<int> frames;
    std::optional<Interval> time;
    std::optional<double> still;  // moment of a single picture
};

struct SceneDescription {
    std::vector<MeshEntry> meshes;
    std::optional<SceneCamera> camera;
    std::optional<std::vector<SceneLight>> lights;
    std::optional<glm::vec3> ambient;
    std::optional<Environment> environment;
    SceneSettings settings;
};

}  // namespace render
