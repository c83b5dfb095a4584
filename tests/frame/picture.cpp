// picture.cpp - libpng's simplified interface.
#include "frame/picture.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace test {
namespace {

uint8_t encode(float linear) {
    const double x = std::clamp(double(linear), 0.0, 1.0);
    const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return uint8_t(std::lround(255 * srgb));
}

png_image png_header(uint32_t width, uint32_t height) {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.format = PNG_FORMAT_RGB;
    image.width = width;
    image.height = height;
    return image;
}

}  // namespace

Picture to_picture(const std::vector<cl_float4>& linear, uint32_t width, uint32_t height) {
    Picture picture = {width, height, {}};
    for (const cl_float4& pixel : linear)
        for (int c = 0; c < 3; ++c) picture.rgb.push_back(encode(pixel.s[c]));
    return picture;
}

Picture read_png(const std::string& path) {
    png_image image = png_header(0, 0);
    if (!png_image_begin_read_from_file(&image, path.c_str()))
        throw std::runtime_error(path + ": " + image.message);
    image.format = PNG_FORMAT_RGB;
    Picture picture = {image.width, image.height, std::vector<uint8_t>(PNG_IMAGE_SIZE(image))};
    if (!png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr))
        throw std::runtime_error(path + ": " + image.message);
    return picture;
}

void write_png(const std::string& path, const Picture& picture) {
    png_image image = png_header(picture.width, picture.height);
    if (!png_image_write_to_file(&image, path.c_str(), 0, picture.rgb.data(), 0, nullptr))
        throw std::runtime_error(path + ": " + image.message);
}

Picture difference(const Picture& a, const Picture& b) {
    Picture made = {a.width, a.height, {}};
    for (size_t i = 0; i < a.rgb.size(); ++i)
        made.rgb.push_back(
            uint8_t(std::clamp(128 + 4 * (int(a.rgb[i]) - int(b.rgb[i])), 0, 255)));
    return made;
}

}  // namespace test
