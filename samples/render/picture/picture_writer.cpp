// picture_writer.cpp - floats into what a format holds, and that into its scanlines.
#include "picture/picture_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "picture/image_file.hpp"

namespace render {
namespace {

// Those that OpenImageIO writes through a proxy, so that writing to the disk stays ours.
constexpr const char* kEndings[] = {".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff",
                                    ".bmp", ".tga", ".hdr", ".ppm",  ".webp"};

constexpr uint32_t kMostWebpSide = 16383;  // of the others, at least 65500

// Encoded at a time; formats pack rows in groups of 16 or 32, the same ones for any strips.
constexpr uint32_t kRows = 64;

float srgb_from_linear(float linear) {
    const float x = linear > 0.0f ? std::min(linear, 1.0f) : 0.0f;  // NaN becomes black
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

std::vector<uint8_t> srgb_bytes(const float* pixels, size_t count) {
    std::vector<uint8_t> bytes(3 * count);
    for (size_t i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = 255.0f * srgb_from_linear(pixels[4 * i + c]);
            bytes[3 * i + c] = static_cast<uint8_t>(std::lround(value));
        }
    return bytes;
}

bool is_linear(const std::string& path) {
    return ending_of(path) == ".exr" || ending_of(path) == ".hdr";
}

OIIO::ImageSpec spec_of(const std::string& path, uint32_t width, uint32_t height) {
    const std::string ending = ending_of(path);
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height),
                         ending == ".exr" ? 4 : 3,
                         is_linear(path) ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    // Told of a colour space, OpenImageIO 2.4 makes TIFF files that it cannot read itself.
    if (ending.rfind(".tif", 0) != 0)
        spec.attribute("oiio:ColorSpace", is_linear(path) ? "Linear" : "sRGB");
    return spec;
}

}  // namespace

void require_format(const std::string& path, uint32_t width, uint32_t height) {
    const std::string ending = ending_of(path);
    if (std::find(std::begin(kEndings), std::end(kEndings), ending) == std::end(kEndings))
        throw std::runtime_error(fmt::format("{}: found the ending \"{}\", allowed: {}", path,
                                             ending, fmt::join(kEndings, ", ")));
    if (ending == ".webp" && std::max(width, height) > kMostWebpSide)
        throw std::runtime_error(
            fmt::format("{}: is {} x {} pixels, a .webp has at most {} a side", path, width,
                        height, kMostWebpSide));
}

PictureWriter::PictureWriter(WholeFile& file, const std::string& path, uint32_t width,
                             uint32_t height, const std::string& description)
    : is_linear_(is_linear(path)) {
    require_format(path, width, height);
    OIIO::ImageSpec spec = spec_of(path, width, height);
    if (!description.empty()) spec.attribute("ImageDescription", description);
    image_ = std::make_unique<ImageFile>(file, path, spec);
}

PictureWriter::~PictureWriter() = default;

void PictureWriter::write(const Strip& strip) {
    for (uint32_t row = 0; row < strip.rows; row += kRows)
        write_rows(strip.first_row + row, std::min(kRows, strip.rows - row), strip.width,
                   &strip.pixels[size_t{4} * strip.width * row]);
}

void PictureWriter::write_rows(uint32_t first_row, uint32_t rows, uint32_t width,
                               const float* pixels) {
    if (is_linear_)
        return image_->write(first_row, rows, OIIO::TypeDesc::FLOAT, pixels, 4 * sizeof(float));
    const std::vector<uint8_t> bytes = srgb_bytes(pixels, size_t{width} * rows);
    image_->write(first_row, rows, OIIO::TypeDesc::UINT8, bytes.data());
}

void PictureWriter::finish() {
    image_->finish();
}

}  // namespace render
