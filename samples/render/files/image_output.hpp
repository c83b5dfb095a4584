// image_output.hpp - frames to images on disk, through OpenImageIO. Reads none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace render {

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
