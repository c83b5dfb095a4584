// image_input.hpp - images on disk, as textures and environments, through OpenImageIO. Writes none.
#pragma once

#include <cstddef>
#include <string>

#include "files/asset.hpp"
#include "model/model.hpp"

namespace render {

// Pixels of one image: 16384 x 8192. As floats they take 2 GiB.
constexpr size_t kMaxTexturePixels = size_t{1} << 27;

// Reads any image that OpenImageIO can, also inside an archive (see asset.hpp). Throws
// std::runtime_error, before it allocates, for more than `max_pixels`.
//
// Integers of any depth are sRGB unless the file says otherwise (gAMA of PNG, "linear"); floats are
// linear. 8 bits that are sRGB stay bytes, all others become linear floats. Alpha is handed on, but
// does not touch the colours: they are those that the file stores.
Image load_image(const std::string& path, size_t max_pixels = kMaxTexturePixels);

// The same of bytes that were read already; the ending of their location names the format.
Image decode_image(const Asset& asset, size_t max_pixels = kMaxTexturePixels);

}  // namespace render
