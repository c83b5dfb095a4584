// texture_set.cpp - packs images behind each other.
#include "scene/texture_set.hpp"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

#include "files/image_input.hpp"

namespace render {

uint32_t TextureSet::add(const std::string& path, bool clamps) {
    if (const auto found = index_of_.find({path, clamps}); found != index_of_.end())
        return found->second;
    return add(path, load_image(path, max_pixels_), clamps);
}

uint32_t TextureSet::add(const Material& material) {
    const std::string& name = material.texture;
    const bool clamps = material.clamps_texture;
    if (!material.texture_bytes) return add(name, clamps);
    if (const auto found = index_of_.find({name, clamps}); found != index_of_.end())
        return found->second;
    return add(name, decode_image({name, *material.texture_bytes}, max_pixels_), clamps);
}

uint32_t TextureSet::add(const std::string& path, const Image& image, bool clamps) {
    const bool is_bytes = image.format == RSH_TEXEL_SRGB8;
    const size_t words = is_bytes ? image.bytes.size() / 4 : image.floats.size();
    const size_t first = texels_.size();
    if (first + words > UINT32_MAX)
        throw std::runtime_error(fmt::format("{}: found {} words of texels in all, allowed: {}",
                                             path, first + words, UINT32_MAX));
    texels_.resize(first + words);
    const void* source = is_bytes ? static_cast<const void*>(image.bytes.data())
                                  : static_cast<const void*>(image.floats.data());
    std::memcpy(&texels_[first], source, 4 * words);
    textures_.push_back({static_cast<uint32_t>(first),
                         image.width,
                         image.height,
                         image.format,
                         clamps ? RSH_WRAP_CLAMP : RSH_WRAP_REPEAT,
                         {}});
    const auto index = static_cast<uint32_t>(textures_.size() - 1);
    index_of_[{path, clamps}] = index;
    return index;
}

}  // namespace render
