// scene_schema.hpp - the keys of a scene file, their types, ranges and defaults: one function
// per kind of object. README.md beside the scenes is its prose.
#pragma once

#include <string>
#include <vector>

#include "files/json_value.hpp"
#include "scene/scene_description.hpp"

namespace render {

class SceneSchema {
public:
    explicit SceneSchema(std::vector<std::string> folders) : folders_(std::move(folders)) {}

    SceneDescription scene(const JsonValue& value) const;

private:
    MeshEntry mesh(const JsonValue& value) const;
    MeshEntry mesh_from_file(const JsonValue& value) const;
    MaterialChange material(const JsonValue& value) const;
    Environment environment(const JsonValue& value) const;
    std::string file(const JsonValue& value) const;

    std::vector<std::string> folders_;
};

}  // namespace render
