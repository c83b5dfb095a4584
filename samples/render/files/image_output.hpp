// image_output.hpp - frames as the bytes of image files, through OpenImageIO. Writes none.
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

// Throws std::runtime_error unless the ending of `path` is of a format that can be written.
void require_image_ending(const std::string& path);

// The ending of `path` decides: .exr keeps linear floats r, g, b, a, .hdr r, g, b; .png and the
// others get 8 bits of sRGB r, g, b. Throws std::runtime_error, which begins with `path`.
std::string encode_image(const Frame& frame, const std::string& path);

}  // namespace render
