// statue.cpp - a lathe's outline, with waves on it.
#include "paper/scenes/statue.hpp"

#include <algorithm>
#include <cmath>

namespace bench::paper {
namespace {

constexpr float kTurn = 6.2831853f;
constexpr float kHeight = 2.3f;
constexpr float kNeck = 0.78f;  // of the height

// Radius at a height of 0 to 1: robe, shoulders, neck, head.
float outline(float v) {
    if (v < 0.7f) return 0.62f - 0.32f * std::sin(0.25f * kTurn * v / 0.7f) + 0.12f * v;
    if (v < kNeck) return 0.384f - 0.27f * (v - 0.7f) / (kNeck - 0.7f);
    const float of_head = (v - kNeck) / (1.0f - kNeck);
    return 0.114f + 0.15f * std::sin(0.5f * kTurn * of_head) - 0.114f * of_head * of_head;
}

// Pleats below the neck, curls above: shares of the radius.
float waves(float u, float v) {
    const float turn = kTurn * u;
    if (v < kNeck) {
        const float bent = 16.0f * turn + 5.0f * std::sin(9.0f * v + 2.0f * turn);
        return 0.13f * std::sin(bent) + 0.03f * std::sin(61.0f * turn + 150.0f * v);
    }
    return 0.16f * std::sin(22.0f * turn + 30.0f * v) * std::sin(170.0f * v);
}

glm::vec3 place(float u, float v) {
    const float radius = outline(v) * (1.0f + waves(u, v));
    return {radius * std::cos(kTurn * u), kHeight * v, radius * std::sin(kTurn * u)};
}

uint32_t add_mirror(render::Model& model) {
    render::Material material;
    material.name = "statue";
    material.diffuse = glm::vec3(0.03f);
    material.specular = glm::vec3(0.8f);
    material.shininess = 400.0f;
    material.reflection = glm::vec3(0.9f, 0.88f, 0.84f);
    model.materials.push_back(material);
    return static_cast<uint32_t>(model.materials.size() - 1);
}

void add_triangle(render::Mesh& mesh, glm::uvec3 corners, uint32_t material) {
    mesh.triangles.push_back(corners);
    mesh.material_ids.push_back(material);
}

// Of each vertex from `first` on: the mean of its triangles', by their areas.
void add_normals(render::Mesh& mesh, size_t first_vertex, size_t first_triangle) {
    mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    for (size_t i = first_triangle; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        const glm::vec3 area = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                          mesh.positions[t.z] - mesh.positions[t.x]);
        for (const uint32_t corner : {t.x, t.y, t.z}) mesh.normals[corner] += area;
    }
    for (size_t i = first_vertex; i < mesh.normals.size(); ++i) {
        const float length = glm::length(mesh.normals[i]);
        if (length > 0.0f) mesh.normals[i] /= length;
    }
}

}  // namespace

void add_statue(render::Model& model, int64_t triangles) {
    render::Mesh& mesh = model.mesh;
    const size_t first_vertex = mesh.positions.size();
    const size_t first_triangle = mesh.triangles.size();
    const uint32_t material = add_mirror(model);
    // Columns go round, rows upwards, with two triangles a cell; a cell is about as high as wide.
    const auto columns =
        std::max(16u, static_cast<uint32_t>(std::sqrt(0.5 * double(triangles))));
    const auto rows = std::max(16u, static_cast<uint32_t>(triangles / 2 / columns));
    for (uint32_t row = 0; row <= rows; ++row)
        for (uint32_t column = 0; column < columns; ++column)
            mesh.positions.push_back(
                place(float(column) / float(columns), float(row) / float(rows)));
    const auto base = static_cast<uint32_t>(first_vertex);
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t next = (column + 1) % columns;
            const uint32_t low = base + row * columns, high = low + columns;
            add_triangle(mesh, {low + column, high + column, low + next}, material);
            add_triangle(mesh, {low + next, high + column, high + next}, material);
        }
    if (!mesh.texcoords.empty()) mesh.texcoords.resize(mesh.positions.size());
    add_normals(mesh, first_vertex, first_triangle);
}

}  // namespace bench::paper
