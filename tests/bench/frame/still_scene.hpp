// still_scene.hpp - what a scene of rsh-bench frame is before anything moves: one mesh, materials
// without textures, lights, a camera. Knows no device.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace bench {

enum class Reflector { kSphere, kFloor, kFloor45, kSeveral, kGlass, kFile };

struct SceneSpec {
    std::string name;  // "room-sphere-80k", "kitchen"
    Reflector reflector = Reflector::kSphere;
    int64_t triangles = 0;  // of a room
    std::string file;       // of Reflector::kFile
    bool is_rigid = false;  // moved as a whole: meshes whose makers ask not to deform them
};

struct StillScene {
    render::Mesh mesh;
    std::vector<rsh_material> materials;
    std::vector<render::Light> lights;
    render::Camera camera;
};

// Of every reflector but kFile.
StillScene make_still_room(const SceneSpec& spec);

// Throws std::runtime_error when a file is missing, and where kReadsSceneFiles is false.
StillScene read_still_scene(const SceneSpec& spec);
extern const bool kReadsSceneFiles;

}  // namespace bench
