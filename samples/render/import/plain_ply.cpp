// plain_ply.cpp - PLY -> binary PLY with nothing but positions, normals, texture coordinates
// and index lists. A file that is already so simple that OpenMesh reads it right passes
// unchanged.
#include <algorithm>
#include <cstring>

#include "files/text_scan.hpp"
#include "import/plain_mesh.hpp"
#include "import/ply_header.hpp"

namespace render {
namespace {

constexpr uint32_t kNoVertex = 0x7fffffffu;  // as an index: out of range in every file

bool is_index_list(const PlyProperty& p) {
    return p.count_type != '\0' && (p.name == "vertex_indices" || p.name == "vertex_index");
}

bool is_scalar_of(const PlyElement& element, const char* property, const char* types) {
    const PlyProperty* found = element.find(property);
    return found && found->count_type == '\0' && std::strchr(types, found->type);
}

// What OpenMesh's binary reader gets right (see plain_mesh.hpp for what it does not).
bool is_plain(const PlyHeader& header) {
    if (header.format == PlyHeader::Format::ascii || header.elements.size() != 2) return false;
    const PlyElement& vertex = header.elements[0];
    const PlyElement& face = header.elements[1];
    if (vertex.name != "vertex" || face.name != "face" || face.properties.size() != 1)
        return false;
    for (const PlyProperty& p : vertex.properties)
        if (p.count_type != '\0') return false;
    for (const char* axis : {"x", "y", "z"})
        if (!is_scalar_of(vertex, axis, "fd")) return false;
    for (const char* other : {"nx", "ny", "nz", "u", "v", "s", "t"})
        if (vertex.find(other) && !is_scalar_of(vertex, other, "fd")) return false;
    const PlyProperty& list = face.properties[0];
    return is_index_list(list) && std::strchr("BHi", list.count_type) &&
           std::strchr("bBhHiI", list.type);
}

// Where the value of a vertex property goes: 0..2 position, 3..5 normal, 6, 7 texture
// coordinate, -1 nowhere.
int slot_of(const std::string& property) {
    constexpr const char* kSlots[] = {"x", "y", "z", "nx", "ny", "nz", "u", "v"};
    constexpr const char* kOtherNames[][2] = {{"s", "t"}, {"texture_u", "texture_v"}};
    for (int i = 0; i < 8; ++i)
        if (property == kSlots[i]) return i;
    for (const auto& pair : kOtherNames)
        for (int i = 0; i < 2; ++i)
            if (property == pair[i]) return 6 + i;
    return -1;
}

struct PlyVertex {
    float values[8] = {};  // by slot
};

class PlyRewriter {
public:
    PlyRewriter(const std::string& bytes, PlyHeader header, const std::string& name)
        : header_(std::move(header)), values_(bytes, header_, name), name_(name) {}

    PlainMesh rewrite() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                skip(element);
            // Nothing behind the faces matters, and some files break off there.
            if (element.name == "face") break;
        }
        if (!corner_texcoords_.empty()) split_vertices();
        write();
        return std::move(plain_);
    }

private:
    void read_vertices(const PlyElement& element) {
        for (const char* axis : {"x", "y", "z"})
            if (!element.find(axis))
                throw LoadError(name_ + ": a vertex has no property " + axis);
        plain_.has_normals = element.find("nx") && element.find("ny") && element.find("nz");
        for (const PlyProperty& p : element.properties)
            plain_.has_texcoords = plain_.has_texcoords || slot_of(p.name) == 7;
        for (size_t i = 0; i < element.count; ++i) {
            PlyVertex vertex;
            for (const PlyProperty& p : element.properties) {
                const int slot = p.count_type == '\0' ? slot_of(p.name) : -1;
                if (slot < 0)
                    values_.skip(p);
                else
                    vertex.values[slot] = static_cast<float>(values_.next(p.type));
            }
            vertices_.push_back(vertex);
        }
    }

    void read_faces(const PlyElement& element) {
        if (std::none_of(element.properties.begin(), element.properties.end(), is_index_list))
            throw LoadError(name_ + ": a face has no list property vertex_indices");
        for (size_t i = 0; i < element.count; ++i)
            for (const PlyProperty& p : element.properties) {
                if (is_index_list(p))
                    read_indices(p);
                else if (p.count_type != '\0' && p.name == "texcoord")
                    read_corner_texcoords(p);
                else
                    values_.skip(p);
            }
    }

    void read_indices(const PlyProperty& p) {
        const size_t count = values_.next_count(p.count_type);
        for (size_t i = 0; i < count; ++i) {
            const double index = values_.next(p.type);
            const bool is_valid = index >= 0.0 && index < static_cast<double>(vertices_.size());
            indices_.push_back(is_valid ? static_cast<uint32_t>(index) : kNoVertex);
        }
        ends_.push_back(indices_.size());
    }

    // Two numbers a corner, on each face. Corners without numbers have texture coordinate 0.
    void read_corner_texcoords(const PlyProperty& p) {
        const size_t first = ends_.size() < 2 ? 0 : ends_[ends_.size() - 2];
        corner_texcoords_.resize(indices_.size(), glm::vec2(0.0f));
        const size_t count = values_.next_count(p.count_type);
        for (size_t i = 0; i < count; ++i) {
            const auto value = static_cast<float>(values_.next(p.type));
            if (first + i / 2 < corner_texcoords_.size())
                corner_texcoords_[first + i / 2][static_cast<int>(i % 2)] = value;
        }
    }

    void skip(const PlyElement& element) {
        plain_.warnings.push_back(name_ + ": element " + element.name + " was ignored");
        for (size_t i = 0; i < element.count; ++i)
            for (const PlyProperty& p : element.properties) values_.skip(p);
    }

    // OpenMesh's PLY reader knows texture coordinates of vertices only: every corner becomes
    // one.
    void split_vertices() {
        corner_texcoords_.resize(indices_.size(), glm::vec2(0.0f));
        std::vector<PlyVertex> split;
        for (size_t i = 0; i < indices_.size(); ++i) {
            if (indices_[i] == kNoVertex) continue;
            split.push_back(vertices_[indices_[i]]);
            split.back().values[6] = corner_texcoords_[i].x;
            split.back().values[7] = corner_texcoords_[i].y;
            indices_[i] = static_cast<uint32_t>(split.size() - 1);
        }
        vertices_ = std::move(split);
        plain_.has_texcoords = true;
    }

    template <typename T>
    void append(const T& value) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        const uint16_t probe = 1;
        char first;
        std::memcpy(&first, &probe, 1);
        if (first != 1) std::reverse(bytes, bytes + sizeof(T));
        plain_.text.append(bytes, sizeof(T));
    }

    void write() {
        plain_.format = "ply";
        plain_.vertices = vertices_.size();
        plain_.faces = ends_.size();
        plain_.text = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(plain_.vertices) +
                      "\nproperty float x\nproperty float y\nproperty float z\n"
                      "property float nx\nproperty float ny\nproperty float nz\n"
                      "property float u\nproperty float v\nelement face " +
                      std::to_string(plain_.faces) +
                      "\nproperty list int int vertex_indices\nend_header\n";
        for (const PlyVertex& vertex : vertices_)
            for (const float value : vertex.values) append(value);
        for (size_t face = 0, corner = 0; face < ends_.size(); ++face) {
            append(static_cast<int32_t>(ends_[face] - corner));
            for (; corner < ends_[face]; ++corner) append(indices_[corner]);
        }
    }

    const PlyHeader header_;
    PlyValues values_;
    const std::string name_;
    PlainMesh plain_;
    std::vector<PlyVertex> vertices_;
    std::vector<uint32_t> indices_;
    std::vector<size_t> ends_;                 // face i ends before indices_[ends_[i]]
    std::vector<glm::vec2> corner_texcoords_;  // empty, or one per index
};

PlainMesh unchanged(const std::string& bytes, const PlyHeader& header) {
    const PlyElement& vertex = header.elements[0];
    PlainMesh plain;
    plain.format = "ply";
    plain.text = bytes;
    plain.vertices = vertex.count;
    plain.faces = header.elements[1].count;
    plain.has_normals = vertex.find("nx") && vertex.find("ny") && vertex.find("nz");
    plain.has_texcoords = vertex.find("u") || vertex.find("s");
    return plain;
}

}  // namespace

PlainMesh plain_ply(const std::string& bytes, const std::string& name) {
    const PlyHeader header = read_ply_header(bytes, name);
    PlainMesh plain = is_plain(header) ? unchanged(bytes, header)
                                       : PlyRewriter(bytes, header, name).rewrite();
    plain.texture = header.texture;
    return plain;
}

}  // namespace render
