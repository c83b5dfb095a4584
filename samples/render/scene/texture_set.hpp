// texture_set.hpp - all images of a scene in one array of texels, each file once.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <rsh/rsh_types.h>

#include "model/model.hpp"

namespace render {

class TextureSet {
public:
    // Images of more pixels are refused.
    explicit TextureSet(size_t max_pixels) : max_pixels_(max_pixels) {}

    // Index of the image in the file; throws when it cannot be read. One that is wanted both
    // repeating and clamped is two textures.
    uint32_t add(const std::string& path, bool clamps = false);
    // The same of a material's texture, which may be in its mesh's file.
    uint32_t add(const Material& material);

    const std::vector<rsh_texture>& textures() const { return textures_; }
    const std::vector<uint32_t>& texels() const { return texels_; }

private:
    uint32_t add(const std::string& path, const Image& image, bool clamps);

    size_t max_pixels_;
    std::map<std::pair<std::string, bool>, uint32_t> index_of_;
    std::vector<rsh_texture> textures_;
    std::vector<uint32_t> texels_;  // words of 4 bytes, whatever the format
};

}  // namespace render
