// obj_file.cpp - calls of tinyobjloader -> polygons. It reads 0 for nan, for a comment, and for
// what is no number at all, and skips what stands behind a number: a line with a 0 or with other
// characters than those of numbers is looked at here.
#include "import/mesh_formats.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <istream>
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
    ObjReader(const std::string& bytes, const std::string& name)
        : feed_(bytes, [this](std::string& line) { edit(line); }), name_(name) {}

    ParsedMesh read() {
        std::istream stream(&feed_);
        stream.exceptions(std::ios::badbit);  // passes on what the feed throws
        tinyobj::LoadObjWithCallback(stream, callbacks(), this);
        add_corners();
        drop_bad_polygons(parsed_.soup, name_, parsed_.warnings);
        if (absent_ > 0)
            parsed_.warnings.push_back(
                name_ + ": " + std::to_string(absent_) +
                " corners refer to a normal or texture coordinate out of range");
        return std::move(parsed_);
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

    // tinyobjloader takes blanks for the ends of material files' names, and does not know the old
    // spelling of f.
    void edit(std::string& line) {
        std::string_view rest = line;
        const std::string_view keyword = take_token(rest);
        if (keyword == "mtllib" && known_files_.emplace(trimmed(rest)).second)
            parsed_.material_files.emplace_back(trimmed(rest));
        if (keyword == "fo") line = "f" + std::string(rest);
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

    // The corners in front of a comment.
    int checked_count(const index_t* corners, int count) const {
        std::string_view rest = words();
        const auto is_zero = [](const index_t& c) { return c.vertex_index == 0; };
        if (std::none_of(corners, corners + count, is_zero) &&
            !has_others_than(rest, "0123456789-/"))
            return count;
        for (int i = 0; i < count; ++i) {
            const std::string_view word = take_token(rest);
            if (word.substr(0, 1) == "#") return i;
            if (!parse_integer(word.substr(0, word.find('/'))))
                fail("a face needs corners like 1, 1/2, 1//3 or 1/2/3, but has", word);
        }
        return count;
    }

    // From 1; a negative index counts back from the line that it stands in.
    static int absolute(int index, size_t count) {
        return index < 0 ? static_cast<int>(count) + index + 1 : index;
    }

    void add_face(const index_t* corners, int count) {
        count = checked_count(corners, count);
        for (int i = 0; i < count; ++i) {
            index_t c = corners[i];
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
    ParsedMesh parsed_;
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec2> texcoords_;
    std::vector<index_t> corners_;  // indices from 1; 0: absent
    std::map<std::string, uint32_t> known_materials_;
    std::set<std::string> known_files_;
    uint32_t material_ = kNoMaterial;
    size_t absent_ = 0;
};

}  // namespace

ParsedMesh read_obj(const std::string& bytes, const std::string& name) {
    require_text(bytes, name);
    return ObjReader(bytes, name).read();
}

}  // namespace render
