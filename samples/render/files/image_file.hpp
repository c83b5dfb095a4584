// image_file.hpp - images on disk through OpenImageIO: textures and environments in, frames
// out. Knows no scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace render {

// Reads any image that OpenImageIO can, also inside an archive (see asset.hpp). Images of 8
// bits per channel stay sRGB bytes, all others become linear floats. Throws std::runtime_error.
Image load_image(const std::string& path);

// Linear light, four floats per pixel, rows from top to bottom.
struct Frame {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> pixels;
};

// The ending decides: .exr keeps linear floats r, g, b, a; .png and other 8-bit formats get
// sRGB r, g, b. Throws std::runtime_error.
void save_image(const Frame& frame, const std::string& path);

}  // namespace render
