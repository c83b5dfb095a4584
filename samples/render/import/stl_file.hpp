// stl_file.hpp - STL, text and binary, into a soup.
//
// Not through OpenMesh: its reader merges vertices that differ by up to FLT_MIN and drops the
// triangles that collapse, one NaN swallows every vertex it is compared with (its order is then
// none), and it believes any count in a binary header. Here vertices are merged only if they
// are equal bit for bit, and every triangle stays.
#pragma once

#include <string>

#include "import/soup.hpp"

namespace render {

// `name` starts every message. Throws LoadError.
Soup read_stl(const std::string& bytes, const std::string& name);

}  // namespace render
