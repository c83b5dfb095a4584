// ply_file.hpp - PLY -> polygons with normals and texture coordinates. Other properties and
// elements are not used.
#pragma once

#include <string>

#include "import/soup.hpp"

namespace render {

// `name` starts every message. Throws LoadError.
ParsedMesh read_ply(const std::string& bytes, const std::string& name);

}  // namespace render
