// scene_file.hpp - reads scene files into a SceneDescription. Any other file counts as a mesh.
// It reads no mesh and no image: it only finds them.
#pragma once

#include <string>
#include <vector>

#include "scene/scene_description.hpp"

namespace render {

// A scene file's text; `file` names it in messages, its folder is where paths are looked up
// first. Throws std::runtime_error for whatever the format does not allow.
SceneDescription parse_scene(const std::string& text, const std::string& file);

// Scene files (.json) and mesh files as one scene: meshes and lights of all; of camera,
// ambient, environment and each setting, the first one given.
SceneDescription read_scenes(const std::vector<std::string>& files);

}  // namespace render
