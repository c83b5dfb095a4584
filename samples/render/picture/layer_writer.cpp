// layer_writer.cpp - a channel per member of LayerPixel.
#include "picture/layer_writer.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "picture/image_file.hpp"

namespace render {
namespace {

struct Channel {
    const char* name;
    OIIO::TypeDesc::BASETYPE type;
};
// In the order of LayerPixel.
constexpr Channel kChannels[] = {
    {"Z", OIIO::TypeDesc::FLOAT},         {"N.X", OIIO::TypeDesc::FLOAT},
    {"N.Y", OIIO::TypeDesc::FLOAT},       {"N.Z", OIIO::TypeDesc::FLOAT},
    {"P.X", OIIO::TypeDesc::FLOAT},       {"P.Y", OIIO::TypeDesc::FLOAT},
    {"P.Z", OIIO::TypeDesc::FLOAT},       {"primitive", OIIO::TypeDesc::UINT32},
    {"material", OIIO::TypeDesc::UINT32}, {"tests", OIIO::TypeDesc::UINT32},
};
static_assert(sizeof(LayerPixel) == 4 * std::size(kChannels), "no gaps");

OIIO::ImageSpec spec_of(glm::uvec2 size) {
    OIIO::ImageSpec spec(static_cast<int>(size.x), static_cast<int>(size.y),
                         static_cast<int>(std::size(kChannels)), OIIO::TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (const Channel& channel : kChannels) {
        spec.channelnames.emplace_back(channel.name);
        spec.channelformats.emplace_back(channel.type);
    }
    spec.alpha_channel = -1;
    spec.z_channel = 0;
    return spec;
}

}  // namespace

void require_layer_format(const std::string& path) {
    if (ending_of(path) != ".exr")
        throw std::runtime_error(
            fmt::format("{}: found the ending \"{}\", allowed: .exr", path, ending_of(path)));
}

LayerWriter::LayerWriter(WholeFile& file, const std::string& path, glm::uvec2 size) {
    require_layer_format(path);
    image_ = std::make_unique<ImageFile>(file, path, spec_of(size));
}

LayerWriter::~LayerWriter() = default;

void LayerWriter::write(const LayerStrip& strip) {
    image_->write(strip.first_row, strip.rows, OIIO::TypeDesc::UNKNOWN, strip.pixels.data());
}

void LayerWriter::finish() {
    image_->finish();
}

}  // namespace render
