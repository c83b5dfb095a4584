// view_schema.hpp - the scene file's "camera" and "lights", with their "keys".
#pragma once

#include "files/json_value.hpp"
#include "scene/view/view_keys.hpp"

namespace render {

SceneCamera scene_camera(const JsonValue& value);
std::vector<SceneLight> scene_lights(const JsonValue& value);

}  // namespace render
