// aff_materials.cpp - fills and names of textures -> materials.
#include "import/bart/aff_materials.hpp"

#include "files/asset.hpp"
#include "files/references.hpp"

namespace render {

void AffMaterials::read_plain_fill() {
    Material m;
    const glm::vec3 colour = tokens_.vector("colour");
    m.diffuse = static_cast<float>(tokens_.number("Kd")) * colour;
    m.ambient = m.diffuse;
    m.specular = glm::vec3(static_cast<float>(tokens_.number("Ks")));
    read_rest(m);
}

void AffMaterials::read_fill() {
    Material m;
    m.ambient = tokens_.vector("ambient");
    m.diffuse = tokens_.vector("diffuse");
    m.specular = tokens_.vector("specular");
    read_rest(m);
}

void AffMaterials::read_rest(Material m) {
    m.shininess = static_cast<float>(tokens_.number("Shine"));
    m.reflection = m.specular;
    m.transmission = glm::vec3(static_cast<float>(tokens_.number("T")));
    const auto ior = static_cast<float>(tokens_.number("ior"));
    m.ior = m.transmission.x > 0.0f && ior > 0.0f ? ior : 1.0f;
    add_fill(std::move(m));
}

void AffMaterials::add_fill(Material material) {
    material.name = "aff" + std::to_string(fills_++);
    last_fill_ = static_cast<uint32_t>(scene_.materials.size());
    scene_.materials.push_back(std::move(material));
}

uint32_t AffMaterials::plain() {
    if (fills_ == 0) add_fill({});
    return last_fill_;
}

uint32_t AffMaterials::textured(const std::string& texture) {
    const uint32_t fill = plain();
    const std::string beside = sibling_path(tokens_.location(), texture);
    const auto [entry, is_new] = textured_.emplace(std::pair(fill, beside), 0u);
    if (is_new) {
        Material material = scene_.materials[fill];
        material.name += " " + texture;
        material.texture = find(texture, beside);
        entry->second = static_cast<uint32_t>(scene_.materials.size());
        scene_.materials.push_back(std::move(material));
    }
    return entry->second;
}

const std::string& AffMaterials::find(const std::string& texture, const std::string& beside) {
    const auto [entry, is_new] = found_.emplace(beside, std::string());
    if (is_new) {
        const std::string path = find_reference(tokens_.location(), texture);
        if (find_asset(path))
            entry->second = path;
        else
            scene_.warnings.push_back(tokens_.where() + ": texture " + texture +
                                      " is not there; what has it keeps its plain colour");
    }
    return entry->second;
}

}  // namespace render
