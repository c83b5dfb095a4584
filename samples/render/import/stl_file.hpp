// stl_file.hpp - STL, text and binary -> polygons. Vertices are merged if they are equal bit for
// bit, so that a NaN merges with nothing else and every triangle stays.
#pragma once

#include <string>

#include "import/soup.hpp"

namespace render {

// `name` starts every message. Throws LoadError.
ParsedMesh read_stl(const std::string& bytes, const std::string& name);

}  // namespace render
