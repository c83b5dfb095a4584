// obj_file.cpp - calls of tinyobjloader -> polygons. It reads 0 for nan, for a comment, and for
// what is no number at all, and skips what stands behind a number: a line with a 0 or with other
// characters than those of numbers is looked at here.
#include "import/mesh_formats.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <map>
#include <set>

#include "files/text_scan.hpp"
#include "import/line_feed.hpp"

namespace render {
namespace {

using tinyobj::index_t;
using tinyobj::real_t;

class ObjReader {
public:
    ObjReader(const std::string& bytes, const std::string& name, ParsedMesh& parsed)
        : feed_(bytes, [this](std::string& line) { edit(line); }),
          name_(name),
          parsed_(parsed) {}

    void read() {
        std::istream stream(&feed_);
        stream.exceptions(std::ios::badbit);  // passes on what the feed throws
        tinyobj::LoadObjWithCallback(stream, callbacks(), this);
        add_corners();
        drop_bad_polygons(parsed_.soup, name_, parsed_.warnings);
        if (absent_ > 0)
            parsed_.warnings.push_back(
                name_ + ": " + std::to_string(absent_) +
                " corners refer to a normal or texture coordinate out of range");
    }

private:
    static tinyobj::callback_t callbacks() {
        static_assert(std::is_same_v<real_t, double>, "coordinates must not be rounded early");
        tinyobj::callback_t c;
        c.vertex_cb = [](void* user, real_t x, real_t y, real_t z, real_t) {
            static_cast<ObjReader*>(user)->add_position({x, y, z});
        };
        c.normal_cb = [](void* user, real_t x, real_t y, real_t z) {
            static_cast<ObjReader*>(user)->normals_.push_back(
                {finite(x), finite(y), finite(z)});
        };
        c.texcoord_cb = [](void* user, real_t u, real_t v, real_t) {
            static_cast<ObjReader*>(user)->texcoords_.push_back({finite(u), finite(v)});
        };
        c.index_cb = [](void* user, index_t* corners, int count) {
            static_cast<ObjReader*>(user)->add_face(corners, count);
        };
        c.usemtl_cb = [](void* user, const char* name, int) {
            static_cast<ObjReader*>(user)->use_material(std::string(trimmed(name)));
        };
        return c;
    }

    // tinyobjloader takes blanks for the ends of material files' names, knows neither capitals nor
    // the old spelling of f, and skips what it does not know.
    void edit(std::string& line) {
        std::string_view rest = line;
        const std::string_view keyword = take_token(rest);
        if (keyword.empty() || keyword[0] == '#') return;
        std::string lower = lower_case(keyword);
        if (lower == "fo") lower = "f";
        if (lower == "mtllib" && known_files_.emplace(trimmed(rest)).second)
            parsed_.material_files.emplace_back(trimmed(rest));
        if (!is_known(lower)) warn_of(std::string(keyword));
        if (lower != keyword) line = lower + std::string(rest);
    }

    static bool is_known(const std::string& keyword) {
        static const std::set<std::string> known{
            "v",      "vt",       "vn",       "f",      "usemtl", "mtllib",     "g",
            "o",      "s",        "l",        "p",      "mg",     "vp",         "deg",
            "bmat",   "step",     "cstype",   "parm",   "trim",   "hole",       "scrv",
            "sp",     "end",      "con",      "bevel",  "lod",    "shadow_obj", "trace_obj",
            "ctech",  "stech",    "c_interp", "usemap", "maplib", "d_interp",   "group",
            "object", "material", "call",     "csh"};
        return known.count(keyword) > 0;
    }

    // Once for each: free-form curves and surfaces, and what may be a v behind odd bytes.
    void warn_of(const std::string& keyword) {
        constexpr size_t kMost = 10;
        if (unknown_.size() == kMost || !unknown_.insert(keyword).second) return;
        parsed_.warnings.push_back(name_ + ", line " + std::to_string(feed_.number()) + ": '" +
                                   keyword.substr(0, 40) + "' is ignored");
    }

    // Bent shading is better than none.
    static float finite(real_t value) {
        const auto rounded = static_cast<float>(value);
        return std::isfinite(rounded) ? rounded : 0.0f;
    }

    [[noreturn]] void fail(const std::string& needed, std::string_view found) const {
        throw LoadError(name_ + ", line " + std::to_string(feed_.number()) + ": " + needed +
                        " '" + std::string(found) + "'");
    }

    static bool has_others_than(std::string_view text, const char* characters) {
        return text.find_first_not_of(characters + std::string(" \t\r\n")) != text.npos;
    }

    // The words of the present line behind its keyword.
    std::string_view words() const {
        std::string_view rest = feed_.line();
        take_token(rest);
        return rest;
    }

    void add_position(glm::dvec3 position) {
        std::string_view rest = words();
        const bool is_odd = position.x == 0.0 || position.y == 0.0 || position.z == 0.0 ||
                            has_others_than(rest, "0123456789+-.eE");
        for (int i = 0; is_odd && i < 3; ++i) {
            const std::string_view word = take_token(rest);
            const auto value = parse_number(word);
            if (!value)
                fail("a vertex needs 3 numbers, but coordinate " + std::to_string(i) + " is",
                     word);
            position[i] = *value;
        }
        parsed_.soup.positions.emplace_back(position);
    }

    // The next index of a corner, before the next slash. 0: absent. What does not fit into an int is
    // out of range too.
    int take_index(std::string_view& corner, std::string_view word) const {
        const std::string_view text = corner.substr(0, corner.find('/'));
        corner.remove_prefix(std::min(text.size() + 1, corner.size()));
        if (text.empty()) return 0;
        const double index = parse_number(text).value_or(0.5);
        if (index != std::floor(index))
            fail("a face needs corners like 1, 1/2, 1//3 or 1/2/3, but has", word);
        constexpr double kMost = std::numeric_limits<int>::max();
        return static_cast<int>(std::clamp(index, -kMost, kMost));
    }

    static bool has_long_number(std::string_view text) {
        constexpr size_t kDigits = 9;  // which always fit into an int
        size_t digits = 0;
        for (const char c : text) {
            digits = c >= '0' && c <= '9' ? digits + 1 : 0;
            if (digits > kDigits) return true;
        }
        return false;
    }

    // The corners in front of a comment, read once more where tinyobjloader may be wrong.
    std::vector<index_t> checked(const index_t* first, int count) const {
        std::vector<index_t> corners(first, first + count);
        std::string_view rest = words();
        const auto is_zero = [](const index_t& c) { return c.vertex_index == 0; };
        if (std::none_of(corners.begin(), corners.end(), is_zero) &&
            !has_others_than(rest, "0123456789-/") && !has_long_number(rest))
            return corners;
        for (size_t i = 0; i < corners.size(); ++i) {
            const std::string_view word = take_token(rest);
            if (word.empty() || word[0] == '#') {
                corners.resize(i);
                break;
            }
            std::string_view corner = word;
            if (corner[0] == '/')
                fail("a face needs corners like 1, 1/2, 1//3 or 1/2/3, but has", word);
            corners[i].vertex_index = take_index(corner, word);
            corners[i].texcoord_index = take_index(corner, word);
            corners[i].normal_index = take_index(corner, word);
        }
        return corners;
    }

    // From 1; a negative index counts back from the line that it stands in.
    static int absolute(int index, size_t count) {
        return index < 0 ? static_cast<int>(count) + index + 1 : index;
    }

    void add_face(const index_t* first, int count) {
        for (index_t c : checked(first, count)) {
            c.vertex_index = absolute(c.vertex_index, parsed_.soup.positions.size());
            c.normal_index = absolute(c.normal_index, normals_.size());
            c.texcoord_index = absolute(c.texcoord_index, texcoords_.size());
            corners_.push_back(c);
        }
        parsed_.soup.ends.push_back(corners_.size());
        parsed_.soup.materials.push_back(material_);
    }

    void use_material(const std::string& material) {
        const auto next = static_cast<uint32_t>(parsed_.material_names.size());
        const auto [entry, is_new] = known_materials_.emplace(material, next);
        if (is_new) parsed_.material_names.push_back(material);
        material_ = entry->second;
    }

    // What `index`, from 1, stands for; nothing, and counted, when it is out of range.
    template <typename T>
    bool look_up(int index, const std::vector<T>& values, T& value) {
        if (index == 0) return false;
        const bool is_there = index > 0 && static_cast<size_t>(index) <= values.size();
        if (is_there)
            value = values[static_cast<size_t>(index) - 1];
        else
            ++absent_;
        return is_there;
    }

    // At the end, since faces may stand in front of what they refer to.
    void add_corners() {
        Soup& soup = parsed_.soup;
        for (const index_t& c : corners_) {
            Corner corner;
            corner.vertex = static_cast<uint32_t>(c.vertex_index - 1);
            if (look_up(c.normal_index, normals_, corner.normal))
                soup.corners_have_normals = true;
            if (look_up(c.texcoord_index, texcoords_, corner.texcoord))
                soup.corners_have_texcoords = true;
            soup.corners.push_back(corner);
        }
    }

    LineFeed feed_;
    const std::string name_;
    ParsedMesh& parsed_;
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec2> texcoords_;
    std::vector<index_t> corners_;  // indices from 1; 0: absent
    std::map<std::string, uint32_t> known_materials_;
    std::set<std::string> known_files_, unknown_;
    uint32_t material_ = kNoMaterial;
    size_t absent_ = 0;
};

}  // namespace

void read_obj(const std::string& bytes, const std::string& name, ParsedMesh& parsed) {
    require_text(bytes, name);
    ObjReader(bytes, name, parsed).read();
}

}  // namespace render
