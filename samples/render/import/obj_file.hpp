// obj_file.hpp - Wavefront OBJ -> polygons, through tinyobjloader. Ignores groups, lines, points
// and free-form surfaces.
#pragma once

#include <string>

#include "import/soup.hpp"

namespace render {

// `name` starts every message. Throws LoadError.
ParsedMesh read_obj(const std::string& bytes, const std::string& name);

}  // namespace render
