// plain_obj.cpp - Wavefront OBJ -> the same with absolute indices, one line per face, every
// polygon with different vertices, and the material of each face beside it. Ignores groups,
// lines, points and free-form surfaces.
#include <algorithm>
#include <map>

#include "files/text_scan.hpp"
#include "import/plain_mesh.hpp"

namespace render {
namespace {

// Indices of one corner as OBJ counts them, from 1; 0: absent.
struct ObjCorner {
    long long vertex = 0, texcoord = 0, normal = 0;
};

class ObjRewriter {
public:
    ObjRewriter(const std::string& bytes, const std::string& name) : rest_(bytes), name_(name) {
        plain_.format = "obj";
    }

    PlainMesh rewrite() {
        while (!rest_.empty()) read_line(next_line());
        plain_.vertices = vertices_;
        plain_.has_normals = normals_ > 0;
        plain_.has_texcoords = texcoords_ > 0;
        for (size_t i = 0; i < ends_.size(); ++i)
            write_face(i, i == 0 ? 0 : ends_[i - 1], ends_[i]);
        warn(out_of_range_, "faces with an index out of range were left out");
        warn(too_short_, "faces with fewer than 3 corners were left out");
        warn(absent_, "corners refer to a normal or texture coordinate out of range");
        return std::move(plain_);
    }

private:
    // A backslash at its end joins a line with the next one.
    std::string_view next_line() {
        ++line_number_;
        std::string_view line = take_line(rest_);
        if (line.empty() || line.back() != '\\') return line;
        joined_.clear();
        while (!line.empty() && line.back() == '\\') {
            joined_.append(line.substr(0, line.size() - 1)).append(" ");
            line = take_line(rest_);
            ++line_number_;
        }
        joined_.append(line);
        return joined_;
    }

    std::string where() const { return name_ + ", line " + std::to_string(line_number_); }

    void warn(size_t count, const char* what) {
        if (count > 0)
            plain_.warnings.push_back(name_ + ": " + std::to_string(count) + " " + what);
    }

    void read_line(std::string_view line) {
        const std::string_view keyword = take_token(line);
        if (keyword == "v")
            read_position(line);
        else if (keyword == "vt")
            append_numbers("vt", line, 2, texcoords_);
        else if (keyword == "vn")
            append_numbers("vn", line, 3, normals_);
        else if (keyword == "f" || keyword == "fo")
            read_face(line);
        else if (keyword == "usemtl")
            material_ = material_index(std::string(trimmed(line)));
        else if (keyword == "mtllib")
            plain_.material_files.emplace_back(trimmed(line));
    }

    void read_position(std::string_view line) {
        std::string_view tokens[3];
        for (std::string_view& token : tokens) token = take_token(line);
        lines_.push_back(plain_.text.size());
        plain_.text += "v ";
        append_position(plain_, static_cast<uint32_t>(vertices_), tokens, where());
        ++vertices_;
    }

    // Missing, non-finite and unreadable components become 0: they bend the shading, not the
    // surface.
    void append_numbers(const char* keyword, std::string_view line, int count, size_t& total) {
        plain_.text += keyword;
        for (int i = 0; i < count; ++i) {
            const std::string_view token = take_token(line);
            const auto value = parse_number(token);
            plain_.text += ' ';
            plain_.text += value && !is_special(*value) ? token : std::string_view("0");
        }
        plain_.text += '\n';
        ++total;
    }

    static long long absolute(long long index, size_t count) {
        return index < 0 ? static_cast<long long>(count) + index + 1 : index;
    }

    // "7", "7/1", "7//3" or "7/1/3"; false for anything else.
    bool read_corner(std::string_view token, ObjCorner& corner) const {
        long long* fields[] = {&corner.vertex, &corner.texcoord, &corner.normal};
        const size_t counts[] = {vertices_, texcoords_, normals_};
        for (int i = 0; i < 3; ++i) {
            const size_t slash = std::min(token.find('/'), token.size());
            const std::string_view text = token.substr(0, slash);
            const auto index = parse_integer(text);
            if (!index && (i == 0 || !text.empty())) return false;
            if (index) *fields[i] = absolute(*index, counts[i]);
            if (slash == token.size()) return true;
            token.remove_prefix(slash + 1);
        }
        return false;
    }

    void read_face(std::string_view line) {
        for (std::string_view t = take_token(line); !t.empty(); t = take_token(line)) {
            if (t[0] == '#') break;
            ObjCorner corner;
            if (!read_corner(t, corner))
                throw LoadError(where() +
                                ": a face needs corners like 1, 1/2, 1//3 or 1/2/3, "
                                "but has '" +
                                std::string(t) + "'");
            corners_.push_back(corner);
        }
        ends_.push_back(corners_.size());
        materials_.push_back(material_);
    }

    uint32_t material_index(const std::string& material) {
        const auto next = static_cast<uint32_t>(plain_.material_names.size());
        const auto [entry, is_new] = indices_.emplace(material, next);
        if (is_new) plain_.material_names.push_back(material);
        return entry->second;
    }

    bool is_in_range(size_t first, size_t end) const {
        return std::all_of(
            corners_.begin() + static_cast<std::ptrdiff_t>(first),
            corners_.begin() + static_cast<std::ptrdiff_t>(end), [&](const ObjCorner& c) {
                return c.vertex > 0 && c.vertex <= static_cast<long long>(vertices_);
            });
    }

    // A face that names a vertex twice would lose a corner in OpenMesh; the second time it gets
    // a copy of the vertex, behind all others so that their numbers stay.
    long long distinct_vertex(size_t first, size_t i) {
        const long long vertex = corners_[i].vertex;
        for (size_t j = first; j < i; ++j)
            if (corners_[j].vertex == vertex) return copy_vertex(vertex);
        return vertex;
    }

    long long copy_vertex(long long vertex) {
        const size_t start = lines_[static_cast<size_t>(vertex) - 1];
        const size_t length = plain_.text.find('\n', start) + 1 - start;
        plain_.text += plain_.text.substr(start, length);
        for (size_t i = 0, n = plain_.special_positions.size(); i < n; ++i) {
            const auto [index, position] = plain_.special_positions[i];
            if (index + 1 == vertex)
                plain_.special_positions.emplace_back(static_cast<uint32_t>(plain_.vertices),
                                                      position);
        }
        return static_cast<long long>(++plain_.vertices);
    }

    void append_index(long long index, size_t count) {
        const bool is_absent = index <= 0 || index > static_cast<long long>(count);
        if (is_absent && index != 0) ++absent_;
        plain_.text += '/';
        if (!is_absent) plain_.text += std::to_string(index);
    }

    void write_face(size_t face, size_t first, size_t end) {
        if (end - first < 3 || !is_in_range(first, end)) {
            ++(end - first < 3 ? too_short_ : out_of_range_);
            return;
        }
        std::vector<long long> vertices;
        for (size_t i = first; i < end; ++i) vertices.push_back(distinct_vertex(first, i));
        plain_.text += 'f';
        for (size_t i = first; i < end; ++i) {
            plain_.text += ' ' + std::to_string(vertices[i - first]);
            append_index(corners_[i].texcoord, texcoords_);
            append_index(corners_[i].normal, normals_);
        }
        plain_.text += '\n';
        plain_.face_materials.push_back(materials_[face]);
        ++plain_.faces;
    }

    std::string_view rest_;
    const std::string name_;
    PlainMesh plain_;
    std::string joined_;
    size_t line_number_ = 0;
    size_t vertices_ = 0, texcoords_ = 0, normals_ = 0;
    std::vector<size_t> lines_;  // where each vertex's line starts in the plain text
    std::vector<ObjCorner> corners_;
    std::vector<size_t> ends_;
    std::vector<uint32_t> materials_;  // per face
    std::map<std::string, uint32_t> indices_;
    uint32_t material_ = kNoMaterial;
    size_t out_of_range_ = 0, too_short_ = 0, absent_ = 0;
};

}  // namespace

PlainMesh plain_obj(const std::string& bytes, const std::string& name) {
    return ObjRewriter(bytes, name).rewrite();
}

}  // namespace render
