// stl_file.cpp - bytes -> triangles. Ignores the stored normals, which repeat what the corners
// say, and the attribute bytes.
#include "import/stl_file.hpp"

#include <cstring>
#include <unordered_map>

#include "files/text_scan.hpp"

namespace render {
namespace {

constexpr size_t kHeaderBytes = 80;
constexpr size_t kTriangleBytes = 50;

class Welder {
public:
    explicit Welder(Soup& soup) : soup_(soup) {}

    void add(glm::vec3 position) {
        const auto next = static_cast<uint32_t>(soup_.positions.size());
        const std::string key(reinterpret_cast<const char*>(&position), sizeof position);
        const auto [entry, is_new] = known_.emplace(key, next);
        if (is_new) soup_.positions.push_back(position);
        soup_.corners.push_back({entry->second, {}, {}});
        if (soup_.corners.size() % 3 == 0) soup_.ends.push_back(soup_.corners.size());
    }

private:
    Soup& soup_;
    std::unordered_map<std::string, uint32_t> known_;
};

uint32_t little_endian_word(const char* bytes) {
    const auto* b = reinterpret_cast<const unsigned char*>(bytes);
    return b[0] | b[1] << 8 | b[2] << 16 | static_cast<uint32_t>(b[3]) << 24;
}

float little_endian_float(const char* bytes) {
    const uint32_t word = little_endian_word(bytes);
    float value;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

Soup read_binary(const std::string& bytes, size_t triangles) {
    Soup soup;
    Welder welder(soup);
    for (size_t i = 0; i < triangles; ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const char* at =
                bytes.data() + kHeaderBytes + 4 + i * kTriangleBytes + 12 + 12 * corner;
            welder.add({little_endian_float(at), little_endian_float(at + 4),
                        little_endian_float(at + 8)});
        }
    return soup;
}

glm::vec3 read_vertex(std::string_view& rest, const std::string& where) {
    glm::vec3 position;
    for (int i = 0; i < 3; ++i) {
        const std::string_view token = take_token(rest);
        const auto value = parse_number(token);
        if (!value)
            throw LoadError(where + ": a vertex needs 3 numbers, but has '" +
                            std::string(token) + "'");
        position[i] = static_cast<float>(*value);
    }
    return position;
}

// Several solids make one soup.
Soup read_text(std::string_view rest, const std::string& name) {
    Soup soup;
    Welder welder(soup);
    size_t facets = 0, loops = 0;
    while (!rest.empty()) {
        std::string_view line = take_line(rest);
        const std::string keyword = lower_case(take_token(line));
        const std::string where = keyword == "vertex" || keyword == "endloop"
                                      ? name + ", facet " + std::to_string(facets)
                                      : std::string();
        if (keyword == "facet") ++facets;
        if (keyword == "vertex") welder.add(read_vertex(line, where));
        if (keyword == "endloop" && soup.corners.size() != 3 * ++loops)
            throw LoadError(where + ": has not 3 vertices");
    }
    if (soup.corners.size() != 3 * facets)
        throw LoadError(name + ": promises " + std::to_string(facets) + " facets, but has " +
                        std::to_string(soup.corners.size()) + " vertices, not 3 for each");
    return soup;
}

Soup read_soup(const std::string& bytes, const std::string& name) {
    const bool has_count = bytes.size() >= kHeaderBytes + 4;
    const size_t triangles = has_count ? little_endian_word(bytes.data() + kHeaderBytes) : 0;
    const size_t needed = kHeaderBytes + 4 + triangles * kTriangleBytes;
    // Many binary files start with "solid" too; their size decides.
    if (has_count && needed == bytes.size()) return read_binary(bytes, triangles);
    std::string_view text = bytes;
    const bool is_text =
        lower_case(take_token(text)) == "solid" && bytes.find('\0') == std::string::npos;
    if (is_text) return read_text(bytes, name);
    if (!has_count)
        throw LoadError(name + ": starts with no 'solid', and " + std::to_string(bytes.size()) +
                        " bytes are less than the 84 of a binary header");
    if (needed < bytes.size()) return read_binary(bytes, triangles);
    throw LoadError(name + ": the header promises " + std::to_string(triangles) +
                    " triangles, which need " + std::to_string(needed) +
                    " bytes, but there are " + std::to_string(bytes.size()));
}

}  // namespace

ParsedMesh read_stl(const std::string& bytes, const std::string& name) {
    ParsedMesh parsed;
    parsed.soup = read_soup(bytes, name);
    return parsed;
}

}  // namespace render
