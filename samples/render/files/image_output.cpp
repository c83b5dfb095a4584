// image_output.cpp - writing of images.
#include "files/image_output.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/asset.hpp"

namespace render {
namespace {

float srgb_from_linear(float linear) {
    const float x = linear > 0.0f ? std::min(linear, 1.0f) : 0.0f;  // NaN becomes black
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

std::vector<uint8_t> srgb_bytes(const Frame& frame) {
    const size_t count = static_cast<size_t>(frame.width) * frame.height;
    std::vector<uint8_t> bytes(3 * count);
    for (size_t i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = 255.0f * srgb_from_linear(frame.pixels[4 * i + c]);
            bytes[3 * i + c] = static_cast<uint8_t>(std::lround(value));
        }
    return bytes;
}

}  // namespace

void save_image(const Frame& frame, const std::string& path) {
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) throw std::runtime_error(fmt::format("{}: {}", path, OIIO::geterror()));
    const bool is_linear = inner_extension(path) == "exr";
    const OIIO::TypeDesc type = is_linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(frame.width, frame.height, is_linear ? 4 : 3, type);
    spec.attribute("oiio:ColorSpace", is_linear ? "Linear" : "sRGB");
    bool is_written = output->open(path, spec);
    if (is_linear)
        is_written = is_written && output->write_image(type, frame.pixels.data());
    else
        is_written = is_written && output->write_image(type, srgb_bytes(frame).data());
    if (!(is_written && output->close()))
        throw std::runtime_error(fmt::format("{}: {}", path, output->geterror()));
}

}  // namespace render
