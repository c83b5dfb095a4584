// picture.hpp - 8-bit sRGB pictures as PNG files, for the golden images: small, and any viewer
// shows them. Not for measuring: 8 bits hide differences below 1/255.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rsh/rsh_types.h>

namespace test {

struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgb;
};

Picture to_picture(const std::vector<cl_float4>& linear, uint32_t width, uint32_t height);

// Throw with the file's name.
Picture read_png(const std::string& path);
void write_png(const std::string& path, const Picture& picture);

// 128 where two pictures of one size agree, difference four times enlarged around that.
Picture difference(const Picture& a, const Picture& b);

}  // namespace test
