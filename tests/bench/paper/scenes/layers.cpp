// layers.cpp - the camera stands between the mirror and the sheets, and looks into the mirror.
#include "paper/scenes/layers.hpp"

#include <algorithm>
#include <cmath>

namespace bench::paper {
namespace {

constexpr float kHalfWidth = 8.0f;  // of a sheet: more than the mirror shows
constexpr float kFirst = 3.0f, kGap = 0.05f;

enum : uint32_t { kMirror, kSheet };

void add_triangle(render::Mesh& mesh, glm::uvec3 corners, uint32_t material) {
    mesh.triangles.push_back(corners);
    mesh.material_ids.push_back(material);
}

// A square of cells x cells cells across z, a little wavy, so that its triangles have no common plane.
void add_sheet(render::Mesh& mesh, float z, uint32_t cells, uint32_t material) {
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    const float wave = cells > 1 ? 0.2f * kGap : 0.0f;
    for (uint32_t y = 0; y <= cells; ++y)
        for (uint32_t x = 0; x <= cells; ++x) {
            const float px = kHalfWidth * (2.0f * float(x) / float(cells) - 1.0f);
            const float py = kHalfWidth * (2.0f * float(y) / float(cells) - 1.0f);
            mesh.positions.push_back(
                {px, py, z + wave * std::sin(5.0f * px) * std::sin(7.0f * py)});
        }
    for (uint32_t y = 0; y < cells; ++y)
        for (uint32_t x = 0; x < cells; ++x) {
            const uint32_t low = base + y * (cells + 1) + x, high = low + cells + 1;
            add_triangle(mesh, {low, low + 1, high}, material);
            add_triangle(mesh, {high, low + 1, high + 1}, material);
        }
}

std::vector<rsh_material> materials() {
    std::vector<rsh_material> all(2);
    for (rsh_material& material : all) {
        material = rsh_material{};
        material.diffuse = {{0.5f, 0.5f, 0.5f, 0}};
        material.specular = {{0, 0, 0, 1}};
        material.transmission = {{0, 0, 0, 1}};
        material.texture = RSH_NO_TEXTURE;
    }
    all[kMirror].reflection = {{0.9f, 0.9f, 0.9f, 0}};
    return all;
}

}  // namespace

StillScene make_layers(int64_t triangles, uint32_t layers) {
    StillScene scene;
    const double of_a_layer = double(triangles) / layers;
    const auto cells =
        std::max(1u, static_cast<uint32_t>(std::lround(std::sqrt(0.5 * of_a_layer))));
    add_sheet(scene.mesh, 0.0f, 1, kMirror);
    for (uint32_t i = 0; i < layers; ++i)
        add_sheet(scene.mesh, kFirst + kGap * float(i), cells, kSheet);
    scene.materials = materials();
    render::Light light;
    light.position = {0.0f, 2.0f, 2.0f};
    scene.lights = {light};
    scene.camera.eye = {0.0f, 0.0f, 1.5f};
    scene.camera.at = glm::vec3(0.0f);
    return scene;
}

}  // namespace bench::paper
