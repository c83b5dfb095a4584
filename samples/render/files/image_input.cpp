// image_input.cpp - reading of images, straight into four channels.
#include "files/image_input.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "files/asset.hpp"
#include "files/text_scan.hpp"

namespace render {
namespace {

// How the numbers of a file stand for light.
struct Encoding {
    bool is_linear = false;
    float gamma = 0.0f;  // 0: sRGB's curve
};

Encoding encoding_of(const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point()) return {true};
    const std::string space = lower_case(spec.get_string_attribute("oiio:ColorSpace"));
    const float gamma = spec.get_float_attribute("oiio:Gamma");
    if (space == "linear" || gamma == 1.0f) return {true};
    // Who writes 2.2 means sRGB: it is what PNG's gAMA holds beside the chunk of that name.
    return {false, std::abs(gamma - 2.2f) < 0.05f ? 0.0f : std::max(gamma, 0.0f)};
}

double linear_from(double value, const Encoding& encoding) {
    if (encoding.gamma > 0.0f) return std::pow(value, encoding.gamma);
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// OpenImageIO has made 0..1 of integers, of which 16 bits tell all apart.
void decode(std::vector<float>& rgba, const Encoding& encoding) {
    if (encoding.is_linear) return;
    constexpr size_t kSteps = 65535;
    std::vector<float> table(kSteps + 1);
    for (size_t i = 0; i <= kSteps; ++i)
        table[i] = static_cast<float>(linear_from(static_cast<double>(i) / kSteps, encoding));
    for (size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 != 3) rgba[i] = table[std::lround(std::clamp(rgba[i], 0.0f, 1.0f) * kSteps)];
}

// OpenImageIO multiplies the colours of WebP by alpha, whatever it is asked for.
void divide_by_alpha(std::vector<uint8_t>& rgba) {
    for (size_t i = 0; i < rgba.size(); ++i) {
        const int alpha = rgba[i | 3];
        if (i % 4 != 3 && alpha > 0)
            rgba[i] = static_cast<uint8_t>(std::min(255, (rgba[i] * 255 + alpha / 2) / alpha));
    }
}

// One to four channels, r, g, b, a; `opaque` is the alpha of images without one.
template <typename T>
std::vector<T> read_rgba(OIIO::ImageInput& input, OIIO::TypeDesc type, T opaque,
                         const std::string& path) {
    const OIIO::ImageSpec& spec = input.spec();
    const int channels = std::min(spec.nchannels, 4);
    std::vector<T> rgba(size_t{4} * spec.width * spec.height, opaque);
    if (!input.read_image(0, 0, 0, channels, type, rgba.data(), 4 * sizeof(T)))
        throw std::runtime_error(fmt::format("{}: {}", path, input.geterror()));
    if (channels >= 3) return rgba;
    for (size_t i = 0; i < rgba.size(); i += 4) {
        if (channels == 2) rgba[i + 3] = rgba[i + 1];
        rgba[i + 1] = rgba[i + 2] = rgba[i];
    }
    return rgba;
}

void require_size(const OIIO::ImageSpec& spec, size_t max_pixels, const std::string& path) {
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
        throw std::runtime_error(fmt::format(
            "{}: found {} x {} x {} pixels with {} channels, allowed: a flat picture "
            "with at least one of each",
            path, spec.width, spec.height, spec.depth, spec.nchannels));
    if (spec.image_pixels() > max_pixels)
        throw std::runtime_error(
            fmt::format("{}: found {} x {} pixels, allowed: {} in all, which "
                        "--max-texture-pixels raises",
                        path, spec.width, spec.height, max_pixels));
}

// Some readers of OpenImageIO allocate as soon as they open a file.
void limit_openers(size_t max_pixels) {
    const size_t megabytes = (max_pixels >> 20) * 4 * sizeof(float) + 1;
    OIIO::attribute("limits:imagesize_MB",
                    static_cast<int>(std::min(megabytes, size_t{INT_MAX})));
}

// `proxy`: null for a plain file, which is read at its path.
Image read_image(const std::string& path, const std::string& name,
                 OIIO::Filesystem::IOProxy* proxy, size_t max_pixels) {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    limit_openers(max_pixels);
    if (proxy) wishes.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto input = OIIO::ImageInput::open(name, &wishes);
    if (!input) throw std::runtime_error(fmt::format("{}: {}", path, OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    require_size(spec, max_pixels, path);

    Image image;
    image.width = spec.width;
    image.height = spec.height;
    const Encoding encoding = encoding_of(spec);
    if (spec.format == OIIO::TypeDesc::UINT8 && !encoding.is_linear && encoding.gamma == 0.0f) {
        image.bytes = read_rgba<uint8_t>(*input, OIIO::TypeDesc::UINT8, 255, path);
        if (std::string(input->format_name()) == "webp") divide_by_alpha(image.bytes);
    } else {
        image.format = RSH_TEXEL_FLOAT32;
        image.floats = read_rgba<float>(*input, OIIO::TypeDesc::FLOAT, 1.0f, path);
        decode(image.floats, encoding);
    }
    return image;
}

}  // namespace

Image decode_image(const Asset& asset, size_t max_pixels) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(asset.bytes.data()),
                                         asset.bytes.size());
    return read_image(asset.location, "image." + inner_extension(asset.location), &memory,
                      max_pixels);
}

Image load_image(const std::string& path, size_t max_pixels) {
    Asset asset = read_asset(path);
    // Not every format can be read from memory; a plain file need not be.
    const std::string ending = inner_extension(asset.location);
    const bool is_plain = std::filesystem::is_regular_file(path) &&
                          lower_case(std::filesystem::path(path).extension().string()) ==
                              (ending.empty() ? "" : "." + ending);
    return is_plain ? read_image(path, path, nullptr, max_pixels)
                    : decode_image({path, std::move(asset.bytes)}, max_pixels);
}

}  // namespace render
