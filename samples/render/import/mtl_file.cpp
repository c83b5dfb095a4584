// mtl_file.cpp - lines, spelled plainly -> terms of tinyobjloader -> materials. Reads no image.
#include "import/mtl_file.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>

#include "files/references.hpp"
#include "files/text_scan.hpp"
#include "import/line_feed.hpp"

namespace render {
namespace {

// What counts where a material says nothing else. A negative Tf stands for none.
constexpr const char* kDefaults = "\nKd 0.8 0.8 0.8\nTf -1 -1 -1\nillum 2";

// Up to `most` numbers at the start of `text`.
std::vector<std::string_view> take_numbers(std::string_view& text, size_t most) {
    std::vector<std::string_view> numbers;
    while (numbers.size() < most) {
        std::string_view rest = text;
        const std::string_view word = take_token(rest);
        if (!parse_number(word)) break;
        numbers.push_back(word);
        text = rest;
    }
    return numbers;
}

// What follows the options, which may hold blanks.
std::string texture_name(std::string_view line) {
    for (line = trimmed(line); !line.empty() && line[0] == '-'; line = trimmed(line)) {
        const std::string_view option = take_token(line);
        if (option == "-o" || option == "-s" || option == "-t")
            take_numbers(line, 3);
        else if (option == "-mm")
            take_numbers(line, 2);
        else
            take_token(line);
    }
    return std::string(line);
}

// The value of a term as tinyobjloader is to read it; empty: as if the line were absent.
std::string plain_value(const std::string& keyword, std::string_view text) {
    if (keyword == "newmtl") return std::string(trimmed(text)) + kDefaults;
    if (keyword == "map_Kd") return texture_name(text);
    const std::vector<std::string_view> numbers = take_numbers(text, 3);
    if (numbers.empty()) return {};
    std::string value(numbers[0]);
    // One number is a grey. Terms that are one number ignore the others.
    for (size_t i = 1; i < 3; ++i)
        value.append(" ").append(i < numbers.size() ? numbers[i] : numbers[0]);
    return value;
}

// Lines of the terms that are used, spelled as the format spells them; other lines stay.
void edit(std::string& line) {
    std::string_view rest = line;
    const std::string lower = lower_case(take_token(rest));
    for (const char* known :
         {"newmtl", "Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "Tf", "d", "Tr", "illum", "map_Kd"})
        if (lower == lower_case(known)) {
            const std::string value = plain_value(known, rest);
            line = value.empty() ? "" : known + (" " + value);
            return;
        }
}

glm::vec3 colour(const tinyobj::real_t (&rgb)[3]) {
    return glm::dvec3(rgb[0], rgb[1], rgb[2]);
}

Material to_material(const tinyobj::material_t& terms, const std::string& location) {
    Material m;
    m.name = terms.name;
    m.ambient = colour(terms.ambient);
    m.diffuse = colour(terms.diffuse);
    m.specular = colour(terms.specular);
    m.emission = colour(terms.emission);
    m.shininess = static_cast<float>(terms.shininess);
    if (!terms.diffuse_texname.empty())
        m.texture = find_reference(location, terms.diffuse_texname);
    const auto opacity = static_cast<float>(terms.dissolve);
    m.transmission = glm::vec3(std::clamp(1.0f - opacity, 0.0f, 1.0f));
    switch (terms.illum) {
        case 3:
        case 5:
            m.reflection = m.specular;
            break;
        case 6:
        case 7:
            m.ior = static_cast<float>(terms.ior);
            [[fallthrough]];
        case 4:
        case 9:
            if (terms.transmittance[0] >= 0.0)
                m.transmission = colour(terms.transmittance);
            else if (opacity >= 1.0f)
                m.transmission = glm::vec3(1.0f);
    }
    return m;
}

}  // namespace

void read_mtl(const std::string& text, const std::string& location,
              std::map<std::string, Material>& materials, std::vector<std::string>& warnings) {
    LineFeed feed(text, edit);
    std::istream stream(&feed);
    stream.exceptions(std::ios::badbit);
    std::vector<tinyobj::material_t> read;
    std::map<std::string, int> by_name;
    std::string warning, error;  // the loader's, about d beside Tr
    tinyobj::LoadMtl(&by_name, &read, &stream, &warning, &error);
    for (const tinyobj::material_t& terms : read) {
        if (terms.name.empty()) continue;  // a file without materials yields one
        if (!materials.emplace(terms.name, to_material(terms, location)).second)
            warnings.push_back(location + ": material '" + terms.name +
                               "' is defined again; the first definition stays");
    }
}

}  // namespace render
