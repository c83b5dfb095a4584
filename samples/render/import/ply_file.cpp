// ply_file.cpp - elements of a PLY file, in the order in which they stand -> polygons.
#include "import/mesh_formats.hpp"

#include <algorithm>
#include <cmath>

#include "files/text_scan.hpp"
#include "import/ply_header.hpp"

namespace render {
namespace {

bool is_index_list(const PlyProperty& p) {
    return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
}

// Where the value of a vertex property goes: 0..2 position, 3..5 normal, 6, 7 texture
// coordinate, -1 nowhere.
int slot_of(const PlyProperty& property) {
    constexpr const char* kSlots[] = {"x", "y", "z", "nx", "ny", "nz", "u", "v"};
    constexpr const char* kOtherNames[][2] = {{"s", "t"}, {"texture_u", "texture_v"}};
    if (property.count_type) return -1;
    for (int i = 0; i < 8; ++i)
        if (property.name == kSlots[i]) return i;
    for (const auto& pair : kOtherNames)
        for (int i = 0; i < 2; ++i)
            if (property.name == pair[i]) return 6 + i;
    return -1;
}

class PlyReader {
public:
    PlyReader(const std::string& bytes, const std::string& name, ParsedMesh& parsed)
        : header_(read_ply_header(bytes, name)),
          values_(bytes, header_, name),
          name_(name),
          parsed_(parsed) {}

    void read() {
        parsed_.texture = header_.texture;
        const auto& elements = header_.elements;
        const auto last = std::find_if(elements.rbegin(), elements.rend(), is_used);
        // Nothing behind the last of them matters, and some files break off there.
        for (auto element = elements.begin(); element != last.base(); ++element) read(*element);
        if (soup_.corners_have_texcoords) give_normals_to_corners();
        drop_bad_polygons(soup_, name_, parsed_.warnings);
    }

private:
    static bool is_used(const PlyElement& element) {
        return element.name == "vertex" || element.name == "face" ||
               element.name == "tristrips";
    }

    void read(const PlyElement& element) {
        if (element.name == "vertex")
            read_vertices(element);
        else if (element.name == "face")
            read_faces(element);
        else if (element.name == "tristrips")
            read_strips(element);
        else {
            parsed_.warnings.push_back(name_ + ": element " + element.name + " was ignored");
            values_.skip(element);
        }
    }

    void read_vertices(const PlyElement& element) {
        if (!soup_.positions.empty()) throw LoadError(name_ + ": has two elements vertex");
        for (const char* axis : {"x", "y", "z"})
            if (!element.find(axis))
                throw LoadError(name_ + ": a vertex has no property " + axis);
        const bool has_normals = element.find("nx") && element.find("ny") && element.find("nz");
        std::vector<int> slots;
        for (const PlyProperty& p : element.properties) slots.push_back(slot_of(p));
        const bool has_texcoords = std::count(slots.begin(), slots.end(), 7) > 0;
        for (size_t i = 0; i < element.count; ++i) {
            values_.start_row(element, i);
            double v[8] = {};
            for (size_t k = 0; k < slots.size(); ++k) {
                const PlyProperty& p = element.properties[k];
                if (slots[k] < 0)
                    values_.skip(p);
                else
                    v[slots[k]] = values_.next(*p.type);
            }
            soup_.positions.emplace_back(v[0], v[1], v[2]);
            if (has_normals) soup_.normals.emplace_back(v[3], v[4], v[5]);
            if (has_texcoords) soup_.texcoords.emplace_back(v[6], v[7]);
        }
    }

    void require_indices(const PlyElement& element) const {
        const auto& all = element.properties;
        if (element.count > 0 && std::none_of(all.begin(), all.end(), is_index_list))
            throw LoadError(name_ + ": element " + element.name +
                            " has no list property vertex_indices");
    }

    void read_faces(const PlyElement& element) {
        require_indices(element);
        for (size_t i = 0; i < element.count; ++i) {
            values_.start_row(element, i);
            for (const PlyProperty& p : element.properties) {
                if (is_index_list(p))
                    read_polygon(p);
                else if (p.count_type && p.name == "texcoord")
                    read_corner_texcoords(p);
                else
                    values_.skip(p);
            }
        }
    }

    std::vector<uint32_t> read_indices(const PlyProperty& p) {
        std::vector<uint32_t> indices(values_.next_count(p));
        for (uint32_t& index : indices) {
            const double value = values_.next(*p.type);
            const bool fits = value >= 0.0 && value < kNoVertex && value == std::floor(value);
            index = fits ? static_cast<uint32_t>(value) : kNoVertex;
        }
        return indices;
    }

    void read_polygon(const PlyProperty& p) {
        for (const uint32_t index : read_indices(p)) soup_.corners.push_back({index, {}, {}});
        soup_.ends.push_back(soup_.corners.size());
    }

    void read_strips(const PlyElement& element) {
        require_indices(element);
        for (size_t i = 0; i < element.count; ++i) {
            values_.start_row(element, i);
            for (const PlyProperty& p : element.properties) {
                if (is_index_list(p))
                    add_strips(read_indices(p));
                else
                    values_.skip(p);
            }
        }
    }

    // Each index makes a triangle with the two before it, every second one the other way round.
    // A -1 ends a strip; triangles without area turn it around a corner.
    void add_strips(const std::vector<uint32_t>& indices) {
        size_t start = 0;
        for (size_t i = 0; i < indices.size(); ++i) {
            if (indices[i] == kNoVertex) start = i + 1;
            if (i < start + 2) continue;
            const bool is_odd = (i - start) % 2 != 0;
            const uint32_t a = indices[i - 2 + is_odd], b = indices[i - 1 - is_odd];
            if (a == b || a == indices[i] || b == indices[i]) continue;
            for (const uint32_t index : {a, b, indices[i]})
                soup_.corners.push_back({index, {}, {}});
            soup_.ends.push_back(soup_.corners.size());
        }
    }

    // Two numbers a corner, on each face. Corners without numbers have texture coordinate 0.
    void read_corner_texcoords(const PlyProperty& p) {
        soup_.corners_have_texcoords = true;
        const size_t first = soup_.ends.size() < 2 ? 0 : soup_.ends[soup_.ends.size() - 2];
        const size_t count = values_.next_count(p);
        for (size_t i = 0; i < count; ++i) {
            const auto value = static_cast<float>(values_.next(*p.type));
            if (first + i / 2 < soup_.corners.size())
                soup_.corners[first + i / 2].texcoord[static_cast<int>(i % 2)] = value;
        }
    }

    // A soup has its attributes either per position or per corner.
    void give_normals_to_corners() {
        soup_.corners_have_normals = !soup_.normals.empty();
        for (Corner& corner : soup_.corners)
            if (corner.vertex < soup_.normals.size())
                corner.normal = soup_.normals[corner.vertex];
    }

    const PlyHeader header_;
    PlyValues values_;
    const std::string name_;
    ParsedMesh& parsed_;
    Soup& soup_ = parsed_.soup;
};

}  // namespace

void read_ply(const std::string& bytes, const std::string& name, ParsedMesh& parsed) {
    PlyReader(bytes, name, parsed).read();
}

}  // namespace render
