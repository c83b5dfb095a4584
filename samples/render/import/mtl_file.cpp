// mtl_file.cpp - lines, checked and spelled plainly -> terms of tinyobjloader -> materials. Reads
// no image.
#include "import/mtl_file.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <istream>

#include "files/references.hpp"
#include "files/text_scan.hpp"
#include "import/line_feed.hpp"

namespace render {
namespace {

// What counts where a material says nothing else. A negative Tf stands for none.
constexpr const char* kDefaults = "\nKd 0.8 0.8 0.8\nTf -1 -1 -1\nillum 2";
// A term of our own beside d and Tr, since 1 is their default too.
constexpr const char* kStatesOpacity = "states_opacity";

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

bool is_finite_float(std::string_view word) {
    return std::isfinite(static_cast<float>(parse_number(word).value_or(INFINITY)));
}

std::string joined(const std::vector<std::string_view>& words) {
    std::string text;
    for (const std::string_view word : words) text.append(" ").append(word);
    return text;
}

// Lines of the terms that are used, spelled as tinyobjloader expects them. Other lines stay.
class PlainLines {
public:
    PlainLines(const std::string& location, std::vector<std::string>& warnings)
        : location_(location), warnings_(warnings) {}

    void edit(std::string& line, size_t number) {
        std::string_view rest = line;
        const std::string lower = lower_case(take_token(rest));
        number_ = number;
        for (const char* known : {"newmtl", "Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "Tf", "d", "Tr",
                                  "illum", "map_Kd"}) {
            if (lower != lower_case(known)) continue;
            keyword_ = known;
            const std::string value = plain_value(rest);
            line = value.empty() ? "" : keyword_ + " " + value;
            return;
        }
    }

private:
    // Empty: as if the line were absent.
    std::string plain_value(std::string_view text) {
        if (keyword_ == "newmtl") return std::string(trimmed(text)) + kDefaults;
        if (keyword_ == "map_Kd") return texture(text);
        if (keyword_ == "illum") return illumination(text);
        const std::vector<std::string_view> numbers = take_numbers(text, 3);
        if (numbers.empty() || !std::all_of(numbers.begin(), numbers.end(), is_finite_float)) {
            warn("'" + std::string(trimmed(numbers.empty() ? text : joined(numbers))) +
                 "' is ignored; needs finite numbers");
            return {};
        }
        std::string value(numbers[0]);
        // One number is a grey. Terms that are one number ignore the others.
        for (size_t i = 1; i < 3; ++i)
            value.append(" ").append(i < numbers.size() ? numbers[i] : numbers[0]);
        if (keyword_ == "d" || keyword_ == "Tr")
            value.append("\n").append(kStatesOpacity).append(" 1");
        return value;
    }

    std::string illumination(std::string_view text) {
        const std::string_view word = take_token(text);
        const double model = parse_number(word).value_or(-1.0);
        if (model >= 0.0 && model <= 10.0 && model == std::floor(model))
            return std::to_string(static_cast<int>(model));
        warn("'" + std::string(word) + "' is ignored; needs a whole number from 0 to 10");
        return {};
    }

    // Options, then what may hold blanks: the name.
    std::string texture(std::string_view line) {
        std::string options;
        for (line = trimmed(line); line.size() > 1 && line[0] == '-'; line = trimmed(line)) {
            std::string_view behind = line;
            const std::string option = lower_case(take_token(behind));
            if (trimmed(behind).empty()) break;  // a name that starts with -
            line = behind;
            options += plain_option(option, line);
        }
        return options + std::string(line);
    }

    // Takes the option's values off `line`.
    std::string plain_option(const std::string& option, std::string_view& line) {
        if (option == "-o" || option == "-s" || option == "-t") {
            std::vector<std::string_view> numbers = take_numbers(line, 3);
            const bool is_used = option != "-t" && !numbers.empty() &&
                                 std::all_of(numbers.begin(), numbers.end(), is_finite_float);
            if (!is_used) {
                warn("option " + option + joined(numbers) + " is ignored");
                return {};
            }
            numbers.resize(3, option == "-s" ? "1" : "0");
            return option + joined(numbers) + " ";
        }
        if (option == "-mm") {
            const auto numbers = take_numbers(line, 2);
            const std::string values = joined(numbers);
            if (values != " 0 1") warn("option " + option + values + " is ignored");
            return {};
        }
        const std::string value = lower_case(take_token(line));
        if (option == "-clamp") return option + (value == "on" ? " on " : " off ");
        const bool is_harmless = option == "-blendu" || option == "-blendv" ||
                                 option == "-bm" || option == "-texres" || option == "-type" ||
                                 (option == "-cc" && value == "off");
        if (!is_harmless) warn("option " + option + " " + value + " is ignored");
        return {};
    }

    void warn(const std::string& what) {
        warnings_.push_back(location_ + ", line " + std::to_string(number_) + ": " + keyword_ +
                            ": " + what);
    }

    const std::string& location_;
    std::vector<std::string>& warnings_;
    size_t number_ = 0;
    std::string keyword_;
};

glm::vec3 colour(const tinyobj::real_t (&rgb)[3]) {
    return glm::dvec3(rgb[0], rgb[1], rgb[2]);
}

glm::vec3 transmission(const tinyobj::material_t& terms) {
    const bool refracts = terms.illum == 6 || terms.illum == 7;
    const bool is_filtered = refracts || terms.illum == 4 || terms.illum == 9;
    const auto amount = static_cast<float>(std::clamp(1.0 - terms.dissolve, 0.0, 1.0));
    const glm::vec3 tf = colour(terms.transmittance);
    const bool has_filter = tf.x >= 0.0f && tf != glm::vec3(0.0f);
    if (terms.unknown_parameter.count(kStatesOpacity) > 0)
        return is_filtered && has_filter ? amount * tf : glm::vec3(amount);
    if (!refracts || terms.ior == 1.0) return glm::vec3(0.0f);
    return tf.x >= 0.0f ? tf : glm::vec3(1.0f);
}

Material to_material(const tinyobj::material_t& terms, const std::string& location) {
    Material m;
    m.name = terms.name;
    m.ambient = colour(terms.ambient);
    m.diffuse = colour(terms.diffuse);
    if (terms.illum > 1) m.specular = colour(terms.specular);
    m.emission = colour(terms.emission);
    m.shininess = static_cast<float>(terms.shininess);
    if (!terms.diffuse_texname.empty())
        m.texture = find_reference(location, terms.diffuse_texname);
    const tinyobj::texture_option_t& options = terms.diffuse_texopt;
    m.texture_scale = glm::dvec2(options.scale[0], options.scale[1]);
    m.texture_shift = glm::dvec2(options.origin_offset[0], options.origin_offset[1]);
    m.clamps_texture = options.clamp;
    if (terms.illum == 3 || terms.illum == 5) m.reflection = m.specular;
    m.transmission = transmission(terms);
    if (terms.illum == 6 || terms.illum == 7) m.ior = static_cast<float>(terms.ior);
    return m;
}

}  // namespace

void read_mtl(const std::string& text, const std::string& location,
              std::map<std::string, Material>& materials, std::vector<std::string>& warnings) {
    PlainLines lines(location, warnings);
    LineFeed* feed_of_lines = nullptr;
    LineFeed feed(text, [&](std::string& line) { lines.edit(line, feed_of_lines->number()); });
    feed_of_lines = &feed;
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
