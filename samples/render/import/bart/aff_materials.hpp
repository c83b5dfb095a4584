// aff_materials.hpp - the materials of an AFF scene: one per fill, and one more for each texture that
// things of that fill have. Finds textures, but reads none.
//
// "specular" is BART's word for both the highlight and the mirror, T for how much passes through; so
// reflection = specular and transmission = T in all channels, with ior.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "import/bart/aff_scene.hpp"
#include "import/bart/aff_tokens.hpp"

namespace render {

// Materials go to the scene, and a warning for each texture that is not there: what has it keeps
// its plain colour. The material of the n-th fill is called "aff<n>", from 0, and with a texture
// "aff<n> <texture>". What comes before any fill has a default one, which counts. Throws LoadError.
class AffMaterials {
public:
    AffMaterials(AffTokens& tokens, AffScene& scene) : tokens_(tokens), scene_(scene) {}

    void read_plain_fill();  // "f": colour, Kd, Ks
    void read_fill();        // "fm": ambient, diffuse and specular colour

    // Numbers of materials: of the last fill, or of a default one; and of the same with a texture.
    uint32_t plain();
    uint32_t textured(const std::string& texture);
    bool has_textures() const { return !textured_.empty(); }  // whether there or not

private:
    void read_rest(Material material);
    void add_fill(Material material);
    const std::string& find(const std::string& texture, const std::string& beside);

    AffTokens& tokens_;
    AffScene& scene_;
    size_t fills_ = 0;
    uint32_t last_fill_ = 0;
    // Both by the path beside the file that names the texture. Empty: it is not there.
    std::map<std::string, std::string> found_;
    std::map<std::pair<uint32_t, std::string>, uint32_t> textured_;  // of a fill
};

}  // namespace render
