// scenes.hpp - the scenes of rsh-bench accuracy, each with a camera for pictures of 4 : 3. Knows no
// device.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/still_scene.hpp"
#include "support/scene.hpp"

namespace bench::accuracy {

constexpr float kAspect = 4.0f / 3;

struct Staged {
    test::Scene scene;
    rsh_camera camera;
    cl_uint bounces = 4;  // that it asks for
    float min_weight = 0;
};

struct SceneKind {
    std::string name;
    bool is_quick;  // part of --quick
    std::function<Staged()> make;
};

// Generated, with so many triangles.
SceneKind room_kind(const char* name, int64_t triangles, bool is_quick = false);
// samples/scenes/NAME.json.
SceneKind file_kind(const char* name, bool is_quick = false);

// What needs no file comes first.
const std::vector<SceneKind>& scene_kinds();

// Without textures.
Staged staged(const StillScene& still);

// With textures. Throws std::runtime_error when a file is missing, and where kReadsSceneFiles is false.
Staged read_staged(const std::string& file);

}  // namespace bench::accuracy
