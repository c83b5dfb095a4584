// patch.cpp - chooses each patch's grid so that the triangle count comes out, then fills a
// mesh.
#include "generate/patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace render {
namespace {

struct Grid {
    int64_t columns;
    int64_t rows;
};

int64_t triangles_of(const Patch& patch, Grid grid) {
    return grid.columns * (2 * grid.rows - patch.starts_at_pole - patch.ends_at_pole);
}

Grid grid_at(const Patch& patch, double density) {
    const auto steps = [&](float length, int least) {
        return std::max<int64_t>(least, std::llround(density * patch.detail * length));
    };
    return {steps(patch.size.x, patch.least_columns), steps(patch.size.y, patch.least_rows)};
}

int64_t total_at(const std::vector<Patch>& patches, double density) {
    int64_t total = 0;
    for (const Patch& patch : patches) total += triangles_of(patch, grid_at(patch, density));
    return total;
}

// The total is a staircase that never falls with the density; returns the last step not above
// `triangles`.
double highest_density(const std::vector<Patch>& patches, int64_t triangles) {
    double low = 0.0;
    double high = 1e5;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (total_at(patches, middle) <= triangles ? low : high) = middle;
    }
    return low;
}

// Spends what the staircase left over on further rows, widest grids first.
void add_rows(const std::vector<Patch>& patches, std::vector<Grid>& grids, int64_t missing) {
    std::vector<size_t> order(patches.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return grids[a].columns > grids[b].columns; });
    bool has_added = true;
    while (has_added) {
        has_added = false;
        for (const size_t i : order) {
            const int64_t row = 2 * grids[i].columns;
            if (row > missing) continue;
            ++grids[i].rows;
            missing -= row;
            has_added = true;
        }
    }
}

std::vector<Grid> choose_grids(const std::vector<Patch>& patches, int64_t triangles) {
    const int64_t least = total_at(patches, 0.0);
    if (least > triangles)
        throw std::runtime_error(
            fmt::format("found {} triangles, allowed: at least {}", triangles, least));
    const double density = highest_density(patches, triangles);
    std::vector<Grid> grids;
    for (const Patch& patch : patches) grids.push_back(grid_at(patch, density));
    add_rows(patches, grids, triangles - total_at(patches, density));
    return grids;
}

void append_points(const Patch& patch, Grid grid, Mesh& mesh) {
    for (int64_t row = 0; row <= grid.rows; ++row)
        for (int64_t column = 0; column <= grid.columns; ++column) {
            const SurfacePoint point = patch.at(static_cast<float>(column) / grid.columns,
                                                static_cast<float>(row) / grid.rows);
            mesh.positions.push_back(point.position);
            mesh.normals.push_back(point.normal);
        }
}

// Counter-clockwise as seen from where the surface's normals point.
void append_triangle(glm::uvec3 corners, uint32_t material, Mesh& mesh) {
    const glm::vec3 a = mesh.positions[corners.x];
    const glm::vec3 face =
        glm::cross(mesh.positions[corners.y] - a, mesh.positions[corners.z] - a);
    const glm::vec3 outwards =
        mesh.normals[corners.x] + mesh.normals[corners.y] + mesh.normals[corners.z];
    if (glm::dot(face, outwards) < 0.0f) std::swap(corners.y, corners.z);
    mesh.triangles.push_back(corners);
    mesh.material_ids.push_back(material);
}

void append(const Patch& patch, Grid grid, Mesh& mesh) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const auto stride = static_cast<uint32_t>(grid.columns) + 1;
    append_points(patch, grid, mesh);
    for (uint32_t row = 0; row < grid.rows; ++row)
        for (uint32_t column = 0; column < grid.columns; ++column) {
            const uint32_t a = first + row * stride + column;
            const uint32_t b = a + 1, c = a + stride, d = c + 1;
            if (row > 0 || !patch.starts_at_pole)
                append_triangle({a, b, d}, patch.material, mesh);
            if (row + 1 < grid.rows || !patch.ends_at_pole)
                append_triangle({a, d, c}, patch.material, mesh);
        }
}

}  // namespace

Mesh tessellate(const std::vector<Patch>& patches, int64_t triangles) {
    const std::vector<Grid> grids = choose_grids(patches, triangles);
    Mesh mesh;
    for (size_t i = 0; i < patches.size(); ++i) append(patches[i], grids[i], mesh);
    return mesh;
}

}  // namespace render
