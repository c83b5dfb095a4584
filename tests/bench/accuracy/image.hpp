// image.hpp - pictures in linear colour, in other sizes and as a screen shows them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/vec.hpp"

namespace bench::accuracy {

// Row by row from the top.
struct Image {
    uint32_t width = 0, height = 0;
    std::vector<test::Double3> pixels;

    // Beyond the border there is the nearest pixel of it.
    const test::Double3& at(int64_t x, int64_t y) const;
};

// Means of squares of `side` pixels, both ways a divisor of the size.
Image averaged(const Image& image, uint32_t side);
// Bilinear between the centres of the pixels.
Image interpolated(const Image& image, uint32_t width, uint32_t height);

// 0..1, encoded in sRGB; what is brighter is 1.
Image to_srgb(const Image& linear);
// As in a file.
int in_255(double srgb);

// A PPM of 8 bits. Throws std::runtime_error with the file's name.
void write_picture(const std::string& path, const Image& linear);

}  // namespace bench::accuracy
