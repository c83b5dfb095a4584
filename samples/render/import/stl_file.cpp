// stl_file.cpp - bytes -> triangles. Ignores the stored normals, which repeat what the corners
// say, and the attribute bytes.
#include "import/mesh_formats.hpp"

#include "files/little_endian.hpp"
#include "files/text_scan.hpp"
#include "model/weld.hpp"

namespace render {
namespace {

constexpr size_t kHeaderBytes = 80;
constexpr size_t kTriangleBytes = 50;

// All corners, one triangle after the other.
using Corners = std::vector<glm::vec3>;

Corners read_binary(const std::string& bytes, size_t triangles) {
    Corners corners;
    for (size_t i = 0; i < 3 * triangles; ++i) {
        const char* at =
            bytes.data() + kHeaderBytes + 4 + i / 3 * kTriangleBytes + 12 + i % 3 * 12;
        corners.push_back({little_endian_float(at), little_endian_float(at + 4),
                           little_endian_float(at + 8)});
    }
    return corners;
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

// A solid's name is the rest of its line, up to its first facet if that is there as well.
void skip_name(std::string_view& rest) {
    std::string_view behind = rest;
    const std::string line = lower_case(take_line(behind));
    const size_t facet = line.find("facet normal");
    rest = facet == line.npos ? behind : rest.substr(facet);
}

// Several solids make one soup. Words count, not lines.
Corners read_text(std::string_view rest, const std::string& name) {
    Corners corners;
    size_t facets = 0, loops = 0;
    while (!rest.empty()) {
        const std::string keyword = lower_case(take_token(rest));
        if (keyword == "facet") ++facets;
        if (keyword == "solid" || keyword == "endsolid") skip_name(rest);
        if (keyword != "vertex" && keyword != "endloop") continue;
        const std::string where = name + ", facet " + std::to_string(facets);
        if (keyword == "vertex") corners.push_back(read_vertex(rest, where));
        if (keyword == "endloop" && corners.size() != 3 * ++loops)
            throw LoadError(where + ": has not 3 vertices");
    }
    if (corners.size() != 3 * facets)
        throw LoadError(name + ": promises " + std::to_string(facets) + " facets, but has " +
                        std::to_string(corners.size()) + " vertices, not 3 for each");
    return corners;
}

Corners read_corners(const std::string& bytes, ParsedMesh& parsed, const std::string& name) {
    const bool has_count = bytes.size() >= kHeaderBytes + 4;
    const size_t triangles = has_count ? little_endian_word(bytes.data() + kHeaderBytes) : 0;
    const size_t needed = kHeaderBytes + 4 + triangles * kTriangleBytes;
    // Many binary files start with "solid" too; their size decides.
    if (has_count && needed == bytes.size()) return read_binary(bytes, triangles);
    const std::string_view text = without_mark(bytes);
    std::string_view rest = text;
    const bool is_text =
        lower_case(take_token(rest)) == "solid" && bytes.find('\0') == std::string::npos;
    if (is_text) return read_text(text, name);
    const std::string size = std::to_string(bytes.size()) + " bytes";
    if (!has_count)
        throw LoadError(name + ": starts with no 'solid', and " + size +
                        " are less than the 84 of a binary header");
    const std::string promise = "the header promises " + std::to_string(triangles) +
                                " triangles, which need " + std::to_string(needed) +
                                " bytes, but there are " + std::to_string(bytes.size());
    if (needed > bytes.size()) throw LoadError(name + ": " + promise);
    parsed.warnings.push_back(name + ": " + promise);
    // Who writes without knowing the end leaves a 0.
    const size_t possible = (bytes.size() - kHeaderBytes - 4) / kTriangleBytes;
    return read_binary(bytes, triangles == 0 ? possible : triangles);
}

}  // namespace

void read_stl(const std::string& bytes, const std::string& name, ParsedMesh& parsed) {
    Soup& soup = parsed.soup;
    Weld weld;
    for (const glm::vec3& position : read_corners(bytes, parsed, name)) {
        soup.corners.push_back({weld(position), {}, {}});
        if (soup.corners.size() % 3 == 0) soup.ends.push_back(soup.corners.size());
    }
    soup.positions.assign(weld.positions().begin(), weld.positions().end());
}

}  // namespace render
