// mtl_file.cpp - lines -> terms -> materials. Reads no image.
#include "import/mtl_file.hpp"

#include <algorithm>
#include <optional>

#include "files/asset.hpp"
#include "files/text_scan.hpp"

namespace render {
namespace {

struct MtlTerms {
    Material material;
    std::optional<glm::vec3> filter;         // Tf
    std::optional<float> dissolve, opacity;  // d, and 1 - Tr
    float ni = 1.0f;
    int illum = 2;
};

// Options of a map statement with their number of arguments at most; others have one.
constexpr const char* kThreeNumbers[] = {"-o", "-s", "-t"};

std::optional<float> take_float(std::string_view& line) {
    std::string_view peek = line;
    const auto value = parse_number(take_token(peek));
    if (!value) return std::nullopt;
    line = peek;
    return static_cast<float>(*value);
}

// One number is a grey.
void read_colour(std::string_view line, glm::vec3& colour) {
    const auto r = take_float(line);
    if (!r) return;
    const auto g = take_float(line);
    const auto b = take_float(line);
    colour = {*r, g.value_or(*r), b.value_or(*r)};
}

// What follows the options, which may hold blanks.
std::string texture_name(std::string_view line) {
    for (line = trimmed(line); !line.empty() && line[0] == '-'; line = trimmed(line)) {
        const std::string_view option = take_token(line);
        const bool takes_numbers = std::find(std::begin(kThreeNumbers), std::end(kThreeNumbers),
                                             option) != std::end(kThreeNumbers);
        if (!takes_numbers && option != "-mm") take_token(line);
        for (int i = 0; i < (takes_numbers ? 3 : option == "-mm" ? 2 : 0); ++i)
            take_float(line);
    }
    std::string name(line);
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

void read_term(const std::string& keyword, std::string_view line, const std::string& location,
               MtlTerms& terms) {
    Material& m = terms.material;
    if (keyword == "ka") read_colour(line, m.ambient);
    if (keyword == "kd") read_colour(line, m.diffuse);
    if (keyword == "ks") read_colour(line, m.specular);
    if (keyword == "ke") read_colour(line, m.emission);
    if (keyword == "ns") m.shininess = take_float(line).value_or(m.shininess);
    if (keyword == "ni") terms.ni = take_float(line).value_or(terms.ni);
    if (keyword == "illum") terms.illum = static_cast<int>(take_float(line).value_or(2.0f));
    if (keyword == "d") terms.dissolve = take_float(line);
    if (keyword == "tr")
        if (const auto transparency = take_float(line)) terms.opacity = 1.0f - *transparency;
    if (keyword == "tf") read_colour(line, terms.filter.emplace(1.0f));
    if (keyword == "map_kd") {
        const std::string name = texture_name(line);
        if (!name.empty()) m.texture = sibling_path(location, name);
    }
}

Material to_material(const MtlTerms& terms) {
    Material m = terms.material;
    const float opacity = terms.dissolve.value_or(terms.opacity.value_or(1.0f));
    const glm::vec3 see_through(std::clamp(1.0f - opacity, 0.0f, 1.0f));
    switch (terms.illum) {
        case 3:
        case 5:
            m.reflection = m.specular;
            m.transmission = see_through;
            break;
        case 6:
        case 7:
            m.ior = terms.ni;
            [[fallthrough]];
        case 4:
        case 9:
            m.transmission =
                terms.filter.value_or(opacity < 1.0f ? see_through : glm::vec3(1.0f));
            break;
        default:
            m.transmission = see_through;
    }
    return m;
}

}  // namespace

void read_mtl(const std::string& text, const std::string& location,
              std::map<std::string, Material>& materials, std::vector<std::string>& warnings) {
    std::string_view rest = text;
    std::optional<MtlTerms> terms;
    const auto finish = [&] {
        if (terms && !materials.emplace(terms->material.name, to_material(*terms)).second)
            warnings.push_back(location + ": material '" + terms->material.name +
                               "' is defined again; the first definition stays");
    };
    while (!rest.empty()) {
        std::string_view line = take_line(rest);
        const std::string keyword = lower_case(take_token(line));
        if (keyword == "newmtl") {
            finish();
            terms.emplace();
            terms->material.name = std::string(trimmed(line));
        } else if (terms) {
            read_term(keyword, line, location, *terms);
        }
    }
    finish();
}

}  // namespace render
