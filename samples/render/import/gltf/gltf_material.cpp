// gltf_material.cpp - the mapping of gltf_material.hpp, and the image behind a texture.
#include "import/gltf/gltf_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "files/references.hpp"

namespace render {
namespace {

double extension_number(const tinygltf::Material& material, const char* extension,
                        const char* key, double otherwise) {
    const auto found = material.extensions.find(extension);
    if (found == material.extensions.end() || !found->second.Has(key)) return otherwise;
    return found->second.Get(key).GetNumberAsDouble();
}

struct Glass {
    double transmission = 0.0, ior = 1.5;
};

Glass glass_of(const tinygltf::Material& material) {
    Glass glass;
    glass.transmission =
        extension_number(material, "KHR_materials_transmission", "transmissionFactor", 0.0);
    glass.ior = extension_number(material, "KHR_materials_ior", "ior", 1.5);
    const double alpha = material.pbrMetallicRoughness.baseColorFactor[3];
    if (material.alphaMode == "BLEND" && alpha < 1.0 && glass.transmission == 0.0)
        return {1.0 - alpha, 1.0};
    return glass;
}

// ior 0 is the extension's way to say: reflects all of it.
double dielectric_f0(double ior) {
    const double root = ior > 0.0 ? (ior - 1.0) / (ior + 1.0) : 1.0;
    return root * root;
}

void map_highlight(glm::dvec3 f0, double roughness, Material& m) {
    const double alpha = roughness * roughness;
    const double exponent = std::clamp(2.0 / std::max(alpha * alpha, 1e-8) - 2.0, 1.0, 1e4);
    const double largest = std::max({f0.x, f0.y, f0.z, 1e-6});
    m.shininess = static_cast<float>(exponent);
    m.specular = f0 * std::min((exponent + 8.0) / 8.0, 1.0 / largest);
}

Material mapped(const tinygltf::Material& material) {
    const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
    const Glass glass = glass_of(material);
    const glm::dvec3 colour(pbr.baseColorFactor[0], pbr.baseColorFactor[1],
                            pbr.baseColorFactor[2]);
    const double metal = pbr.metallicFactor, rough = pbr.roughnessFactor;
    const double mirror = metal * (1.0 - rough) * (1.0 - rough);
    const double clear = glass.transmission * (1.0 - metal);
    Material m;
    m.name = material.name;
    m.diffuse = colour * ((1.0 - mirror) * (1.0 - clear));
    m.reflection = colour * mirror;
    m.transmission = colour * clear;
    m.ior = static_cast<float>(clear > 0.0 && glass.ior > 0.0 ? glass.ior : 1.0);
    map_highlight(dielectric_f0(glass.ior) * (1.0 - metal) + colour * mirror, rough, m);
    if (material.emissiveTexture.index < 0 && material.emissiveFactor.size() == 3)
        m.emission = glm::vec3(material.emissiveFactor[0], material.emissiveFactor[1],
                               material.emissiveFactor[2]);
    return m;
}

// "a%20b.png" -> "a b.png"
std::string decoded_uri(const std::string& uri) {
    std::string name;
    for (size_t i = 0; i < uri.size(); ++i) {
        const std::string digits = uri.substr(i + 1, 2);
        const bool is_code =
            uri[i] == '%' && digits.size() == 2 &&
            digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
        name += is_code ? static_cast<char>(std::stoi(digits, nullptr, 16)) : uri[i];
        if (is_code) i += 2;
    }
    return name;
}

// An image's name inside of the file, with the ending that its first bytes call for.
std::string name_inside(const std::string& location, size_t index, const std::string& bytes) {
    return fmt::format("{}: images[{}].{}", location, index,
                       bytes.compare(0, 2, "\xff\xd8") == 0 ? "jpg" : "png");
}

class Textures {
public:
    explicit Textures(GltfDocument& document) : document_(document) {}

    void add(const tinygltf::TextureInfo& info, Material& material) {
        if (info.index < 0) return;
        const auto& texture = document_.model.textures[static_cast<size_t>(info.index)];
        if (texture.source < 0) {
            document_.warnings.push_back(
                fmt::format("{}: textures[{}] has no source that is known", document_.location,
                            info.index));
            return;
        }
        const auto index = static_cast<size_t>(texture.source);
        const tinygltf::Image& image = document_.model.images[index];
        if (image.image.empty()) {
            material.texture = find_reference(document_.location, decoded_uri(image.uri));
        } else {
            auto& bytes = bytes_[index];
            if (!bytes)
                bytes =
                    std::make_shared<const std::string>(image.image.begin(), image.image.end());
            material.texture = name_inside(document_.location, index, *bytes);
            material.texture_bytes = bytes;
        }
        if (texture.sampler >= 0) wrap(texture, material);
    }

private:
    void wrap(const tinygltf::Texture& texture, Material& material) {
        const auto& sampler = document_.model.samplers[static_cast<size_t>(texture.sampler)];
        const auto clamps = [](int way) { return way == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE; };
        material.clamps_texture = clamps(sampler.wrapS) && clamps(sampler.wrapT);
        const bool is_known = sampler.wrapS == sampler.wrapT &&
                              sampler.wrapS != TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
        if (!is_known)
            document_.warnings.push_back(fmt::format(
                "{}: samplers[{}]: wrapS {} and wrapT {} are taken for 10497 (repeat); known "
                "are 10497 and 33071 (clamp) for both",
                document_.location, texture.sampler, sampler.wrapS, sampler.wrapT));
    }

    GltfDocument& document_;
    std::map<size_t, std::shared_ptr<const std::string>> bytes_;
};

void warn_of_ignored(GltfDocument& document) {
    std::map<std::string, size_t> ignored;
    for (const tinygltf::Material& m : document.model.materials) {
        ignored["a metallicRoughnessTexture"] +=
            m.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0;
        ignored["a normalTexture"] += m.normalTexture.index >= 0;
        ignored["an occlusionTexture"] += m.occlusionTexture.index >= 0;
        ignored["an emissiveTexture, with the emissiveFactor"] += m.emissiveTexture.index >= 0;
        ignored["alphaMode MASK"] += m.alphaMode == "MASK";
        const auto glass = m.extensions.find("KHR_materials_transmission");
        ignored["a transmissionTexture"] +=
            glass != m.extensions.end() && glass->second.Has("transmissionTexture");
    }
    for (const auto& [what, count] : ignored)
        if (count > 0)
            document.warnings.push_back(fmt::format("{}: {} of {} materials have {}: ignored",
                                                    document.location, count,
                                                    document.model.materials.size(), what));
}

}  // namespace

std::vector<Material> gltf_materials(GltfDocument& document) {
    std::vector<Material> materials;
    Textures textures(document);
    for (const tinygltf::Material& material : document.model.materials) {
        materials.push_back(mapped(material));
        if (materials.back().name.empty())
            materials.back().name = std::to_string(materials.size() - 1);
        textures.add(material.pbrMetallicRoughness.baseColorTexture, materials.back());
    }
    materials.push_back(mapped(tinygltf::Material()));
    materials.back().name = "default";
    warn_of_ignored(document);
    return materials;
}

std::string gltf_texcoord_name(const tinygltf::Model& model, int material) {
    const int set = material < 0 ? 0
                                 : model.materials[static_cast<size_t>(material)]
                                       .pbrMetallicRoughness.baseColorTexture.texCoord;
    return "TEXCOORD_" + std::to_string(set);
}

}  // namespace render
