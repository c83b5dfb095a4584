// image_file.cpp - reading and writing of images.
#include "files/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "files/asset.hpp"

namespace render {
namespace {

// One to four channels become r, g, b, a; `opaque` is the alpha of images without one.
template <typename T>
std::vector<T> as_rgba(const std::vector<T>& source, size_t pixels, int channels, T opaque) {
    std::vector<T> rgba(4 * pixels);
    const bool is_grey = channels < 3;
    for (size_t i = 0; i < pixels; ++i) {
        const T* from = &source[i * channels];
        for (int c = 0; c < 3; ++c) rgba[4 * i + c] = from[is_grey ? 0 : c];
        rgba[4 * i + 3] = channels == 2 || channels >= 4 ? from[is_grey ? 1 : 3] : opaque;
    }
    return rgba;
}

template <typename T>
std::vector<T> read_pixels(OIIO::ImageInput& input, OIIO::TypeDesc type, T opaque,
                           const std::string& path) {
    const OIIO::ImageSpec& spec = input.spec();
    const size_t pixels = static_cast<size_t>(spec.width) * spec.height;
    std::vector<T> raw(pixels * spec.nchannels);
    if (!input.read_image(0, 0, 0, spec.nchannels, type, raw.data()))
        throw std::runtime_error(fmt::format("{}: {}", path, input.geterror()));
    return as_rgba(raw, pixels, spec.nchannels, opaque);
}

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

Image load_image(const std::string& path) {
    const Asset asset = read_asset(path);
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(asset.bytes.data()),
                                         asset.bytes.size());
    // Not every format can be read from memory; a plain file need not be.
    const bool is_plain = std::filesystem::is_regular_file(path);
    const auto input = is_plain
                           ? OIIO::ImageInput::open(path)
                           : OIIO::ImageInput::open("image." + inner_extension(asset.location),
                                                    nullptr, &memory);
    if (!input) throw std::runtime_error(fmt::format("{}: {}", path, OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    Image image;
    image.width = spec.width;
    image.height = spec.height;
    if (spec.format == OIIO::TypeDesc::UINT8) {
        image.bytes = read_pixels<uint8_t>(*input, OIIO::TypeDesc::UINT8, 255, path);
    } else {
        image.format = RSH_TEXEL_FLOAT32;
        image.floats = read_pixels<float>(*input, OIIO::TypeDesc::FLOAT, 1.0f, path);
    }
    return image;
}

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
