// image_input.hpp - images on disk, as textures and environments, through OpenImageIO. Writes none.
#pragma once

#include <string>

#include "model/model.hpp"

namespace render {

// Reads any image that OpenImageIO can, also inside an archive (see asset.hpp). Throws
// std::runtime_error.
//
// Integers of any depth are sRGB unless the file says otherwise (gAMA of PNG, "linear"); floats are
// linear. 8 bits that are sRGB stay bytes, all others become linear floats. Alpha is handed on, but
// does not touch the colours: they are those that the file stores.
Image load_image(const std::string& path);

}  // namespace render
