#include "import/gltf/gltf_builder.hpp"

#include "temporary_folder.hpp"

namespace render {
namespace {

std::string base64(const std::string& bytes) {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t word = 0;
        for (size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? uint8_t(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[word >> (18 - 6 * k) & 63];
    }
    return text;
}

size_t width_of(const std::string& type) {
    return type == "SCALAR" ? 1 : type == "MAT4" ? 16 : size_t(type[3] - '0');
}

template <typename T>
std::string raw(const std::vector<T>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

std::string padded(std::string bytes, char with) {
    bytes.resize((bytes.size() + 3) / 4 * 4, with);
    return bytes;
}

std::string chunk(const char* type, const std::string& bytes) {
    return bytes_of<uint32_t>({static_cast<uint32_t>(bytes.size())}) + std::string(type, 4) +
           bytes;
}

}  // namespace

int GltfBuilder::view(const std::string& bytes) {
    bytes_ = padded(bytes_, '\0');
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
    bytes_ += bytes;
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfBuilder::add(const std::string& type, int component, const std::string& bytes,
                     size_t numbers) {
    json["accessors"].push_back({{"bufferView", view(bytes)},
                                 {"componentType", component},
                                 {"type", type},
                                 {"count", numbers / width_of(type)}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

int GltfBuilder::floats(const std::string& type, const std::vector<float>& numbers) {
    return add(type, 5126, raw(numbers), numbers.size());
}

int GltfBuilder::bytes(const std::string& type, const std::vector<uint8_t>& numbers) {
    return add(type, 5121, raw(numbers), numbers.size());
}

int GltfBuilder::shorts(const std::string& type, const std::vector<uint16_t>& numbers) {
    return add(type, 5123, raw(numbers), numbers.size());
}

int GltfBuilder::sparse(const std::string& type, size_t count,
                        const std::vector<uint8_t>& places, const std::vector<float>& numbers) {
    const int indices = view(raw(places)), values = view(raw(numbers));
    json["accessors"].push_back(
        {{"componentType", 5126},
         {"type", type},
         {"count", count},
         {"sparse",
          {{"count", places.size()},
           {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
           {"values", {{"bufferView", values}}}}}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

void GltfBuilder::add_mesh(const nlohmann::json& primitive) {
    json["meshes"].push_back({{"primitives", {primitive}}});
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
}

void GltfBuilder::add_triangle(const nlohmann::json& material) {
    nlohmann::json primitive{
        {"attributes", {{"POSITION", floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}}}};
    if (!material.is_null()) {
        json["materials"].push_back(material);
        primitive["material"] = json["materials"].size() - 1;
    }
    add_mesh(primitive);
}

void GltfBuilder::animate(int node, const char* path, const char* interpolation,
                          const std::vector<float>& times, int output) {
    const int input = floats("SCALAR", times);
    nlohmann::json& animation = json["animations"][0];
    animation["channels"].push_back({{"sampler", animation["samplers"].size()},
                                     {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back(
        {{"input", input}, {"output", output}, {"interpolation", interpolation}});
}

std::string GltfBuilder::text() const {
    nlohmann::json whole = json;
    if (!bytes_.empty())
        whole["buffers"] = {
            {{"byteLength", bytes_.size()},
             {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return whole.dump();
}

std::string GltfBuilder::binary() const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", bytes_.size()}}};
    const std::string chunks =
        chunk("JSON", padded(whole.dump(), ' ')) + chunk("BIN\0", padded(bytes_, '\0'));
    return "glTF" + bytes_of<uint32_t>({2, static_cast<uint32_t>(12 + chunks.size())}) + chunks;
}

}  // namespace render
