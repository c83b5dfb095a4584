// image_output.cpp - frames into files in memory.
#include "files/image_output.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "files/text_scan.hpp"

namespace render {
namespace {

// Those that OpenImageIO writes to memory, so that writing to the disk stays ours.
constexpr const char* kEndings[] = {".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff",
                                    ".bmp", ".tga", ".hdr", ".ppm",  ".webp"};

std::string ending_of(const std::string& path) {
    return lower_case(std::filesystem::path(path).extension().string());
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

void require_image_ending(const std::string& path) {
    const std::string ending = ending_of(path);
    for (const char* known : kEndings)
        if (ending == known) return;
    throw std::runtime_error(fmt::format("{}: found the ending \"{}\", allowed: {}", path,
                                         ending, fmt::join(kEndings, ", ")));
}

std::string encode_image(const Frame& frame, const std::string& path) {
    require_image_ending(path);
    const std::string ending = ending_of(path);
    OIIO::Filesystem::IOVecOutput memory;  // outlives what writes to it
    auto output = OIIO::ImageOutput::create("image" + ending);
    if (!output) throw std::runtime_error(fmt::format("{}: {}", path, OIIO::geterror()));
    const bool is_linear = ending == ".exr" || ending == ".hdr";
    const OIIO::TypeDesc type = is_linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(frame.width, frame.height, ending == ".exr" ? 4 : 3, type);
    // Told of a colour space, OpenImageIO 2.4 makes TIFF files that it cannot read itself.
    if (ending.rfind(".tif", 0) != 0)
        spec.attribute("oiio:ColorSpace", is_linear ? "Linear" : "sRGB");
    output->set_ioproxy(&memory);
    bool is_written = output->open("image" + ending, spec);
    if (is_linear)
        is_written =
            is_written && output->write_image(type, frame.pixels.data(), 4 * sizeof(float));
    else
        is_written = is_written && output->write_image(type, srgb_bytes(frame).data());
    if (!(is_written && output->close()))
        throw std::runtime_error(fmt::format("{}: {}", path, output->geterror()));
    output.reset();
    return {memory.buffer().begin(), memory.buffer().end()};
}

}  // namespace render
