// soup.cpp - polygons -> triangles whose corners are shared where all attributes agree. Keeps
// every triangle, also those without area.
#include "model/soup.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>

#include "model/polygon.hpp"

namespace render {
namespace {

// Bits, not values: a NaN equals itself and no two different corners are ever merged.
struct CornerBits {
    uint32_t words[6];
    bool operator==(const CornerBits& other) const {
        return std::memcmp(words, other.words, sizeof words) == 0;
    }
};

struct HashBits {
    size_t operator()(const CornerBits& bits) const {
        uint64_t hash = 14695981039346656037ull;  // FNV-1a, a word at a time
        for (const uint32_t word : bits.words) hash = (hash ^ word) * 1099511628211ull;
        return static_cast<size_t>(hash ^ (hash >> 29));
    }
};

CornerBits bits_of(const Corner& corner) {
    CornerBits bits;
    bits.words[0] = corner.vertex;
    std::memcpy(bits.words + 1, &corner.normal, sizeof corner.normal);
    std::memcpy(bits.words + 4, &corner.texcoord, sizeof corner.texcoord);
    return bits;
}

size_t first_corner(const Soup& soup, size_t polygon) {
    return polygon == 0 ? 0 : soup.ends[polygon - 1];
}

void add_triangles(const Soup& soup, size_t first, size_t end,
                   const std::vector<uint32_t>& vertex_of_corner, Mesh& mesh) {
    std::vector<glm::dvec3> polygon;
    for (size_t i = first; i < end; ++i)
        polygon.push_back(soup.positions[soup.corners[i].vertex]);
    for (const glm::uvec3 t : triangulate(polygon))
        mesh.triangles.push_back({vertex_of_corner[first + t.x], vertex_of_corner[first + t.y],
                                  vertex_of_corner[first + t.z]});
}

void add_polygons(const Soup& soup, const std::vector<uint32_t>& vertex_of_corner, Mesh& mesh) {
    for (size_t i = 0; i < soup.ends.size(); ++i) {
        add_triangles(soup, first_corner(soup, i), soup.ends[i], vertex_of_corner, mesh);
        mesh.material_ids.resize(mesh.triangles.size(),
                                 soup.materials.empty() ? 0 : soup.materials[i]);
    }
}

double largest(glm::dvec3 v) {
    return std::max(std::max(v.x, v.y), v.z);
}

// Would floats round a polygon's corners by more than 1e-5 of its size?
bool is_coarse_in_float(const Soup& soup, size_t polygon) {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (size_t i = first_corner(soup, polygon); i < soup.ends[polygon]; ++i) {
        low = glm::min(low, soup.positions[soup.corners[i].vertex]);
        high = glm::max(high, soup.positions[soup.corners[i].vertex]);
    }
    const double size = largest(high - low), far = largest(glm::max(-low, high));
    return size > 0.0 && std::isfinite(far) && far * 0x1p-24 > size * 1e-5;
}

// That of all finite values below which this share of them lies; 0 without any.
double quantile(std::vector<double> values, double share) {
    const auto is_huge = [](double v) { return !std::isfinite(static_cast<float>(v)); };
    values.erase(std::remove_if(values.begin(), values.end(), is_huge), values.end());
    if (values.empty()) return 0.0;
    const double last = static_cast<double>(values.size() - 1);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * last);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

// 0 unless many polygons are coarse and the mesh is far from 0. Then the middle of its corners, as a
// float, so that coordinates that are floats stay exact. Corners that lie astray, up to a tenth, do
// not count.
glm::dvec3 origin_of(const Soup& soup) {
    size_t coarse = 0;
    for (size_t i = 0; i < soup.ends.size(); ++i) coarse += is_coarse_in_float(soup, i);
    if (16 * coarse <= soup.ends.size()) return glm::dvec3(0.0);
    glm::dvec3 middle(0.0), size(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Corner& corner : soup.corners)
            values.push_back(soup.positions[corner.vertex][axis]);
        middle[axis] = static_cast<float>(quantile(values, 0.5));
        for (double& value : values) value = std::abs(value - middle[axis]);
        size[axis] = quantile(values, 0.9);
    }
    return largest(glm::abs(middle)) > kFarAgainstSize * largest(size) ? middle
                                                                       : glm::dvec3(0.0);
}

IndexedMesh with_vertices_of_file(const Soup& soup) {
    IndexedMesh result;
    result.mesh.origin = origin_of(soup);
    for (const glm::dvec3& position : soup.positions)
        result.mesh.positions.emplace_back(position - result.mesh.origin);
    result.mesh.normals = soup.normals;
    result.mesh.texcoords = soup.texcoords;
    result.source.resize(soup.positions.size());
    std::iota(result.source.begin(), result.source.end(), 0u);
    std::vector<uint32_t> vertex_of_corner;
    for (const Corner& corner : soup.corners) vertex_of_corner.push_back(corner.vertex);
    add_polygons(soup, vertex_of_corner, result.mesh);
    return result;
}

IndexedMesh with_vertices_of_corners(const Soup& soup) {
    IndexedMesh result;
    result.mesh.origin = origin_of(soup);
    std::unordered_map<CornerBits, uint32_t, HashBits> known;
    std::vector<uint32_t> vertex_of_corner;
    for (const Corner& corner : soup.corners) {
        const auto next = static_cast<uint32_t>(result.source.size());
        const auto [entry, is_new] = known.emplace(bits_of(corner), next);
        vertex_of_corner.push_back(entry->second);
        if (!is_new) continue;
        result.source.push_back(corner.vertex);
        result.mesh.positions.emplace_back(soup.positions[corner.vertex] - result.mesh.origin);
        if (soup.corners_have_normals) result.mesh.normals.push_back(corner.normal);
        if (soup.corners_have_texcoords) result.mesh.texcoords.push_back(corner.texcoord);
    }
    add_polygons(soup, vertex_of_corner, result.mesh);
    return result;
}

// Keeps the polygons for which `keep` is true.
template <typename Keep>
void filter(Soup& soup, Keep keep) {
    Soup kept;
    for (size_t i = 0; i < soup.ends.size(); ++i) {
        const Corner* first = soup.corners.data() + first_corner(soup, i);
        const Corner* end = soup.corners.data() + soup.ends[i];
        if (!keep(first, end)) continue;
        kept.corners.insert(kept.corners.end(), first, end);
        kept.ends.push_back(kept.corners.size());
        if (!soup.materials.empty()) kept.materials.push_back(soup.materials[i]);
    }
    soup.corners = std::move(kept.corners);
    soup.ends = std::move(kept.ends);
    soup.materials = std::move(kept.materials);
}

}  // namespace

void drop_bad_polygons(Soup& soup, const std::string& name,
                       std::vector<std::string>& warnings) {
    size_t too_short = 0, out_of_range = 0;
    const auto is_absent = [&](const Corner& c) { return c.vertex >= soup.positions.size(); };
    filter(soup, [&](const Corner* first, const Corner* end) {
        const bool is_short = end - first < 3;
        const bool is_out = !is_short && std::any_of(first, end, is_absent);
        too_short += is_short;
        out_of_range += is_out;
        return !is_short && !is_out;
    });
    const auto warn = [&](size_t count, const char* what) {
        if (count > 0) warnings.push_back(name + ": " + std::to_string(count) + " " + what);
    };
    warn(out_of_range, "faces with an index out of range were left out");
    warn(too_short, "faces with fewer than 3 corners were left out");
}

IndexedMesh build_mesh(const Soup& soup) {
    return soup.corners_have_normals || soup.corners_have_texcoords
               ? with_vertices_of_corners(soup)
               : with_vertices_of_file(soup);
}

}  // namespace render
