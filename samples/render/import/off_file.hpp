// off_file.hpp - Geomview OFF -> polygons. Colours and other attributes are not used; binary and
// higher-dimensional OFF are refused.
#pragma once

#include <string>

#include "import/soup.hpp"

namespace render {

// `name` starts every message. Throws LoadError, also for a header that promises more than the
// file can hold.
ParsedMesh read_off(const std::string& bytes, const std::string& name);

}  // namespace render
