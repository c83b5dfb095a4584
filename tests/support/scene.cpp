// scene.cpp - materials, lights and scenes, made from code.
#include "support/scene.hpp"

#include <algorithm>
#include <cstring>

namespace test {
namespace {

rsh_float4 rgb(Float3 c, float w = 0) {
    return {{c.x, c.y, c.z, w}};
}

std::vector<Float3> radial_normals(const Mesh& mesh, Float3 centre) {
    std::vector<Float3> normals;
    for (const Float3& v : mesh.vertices) normals.push_back(normalize(v - centre));
    return normals;
}

std::vector<uint32_t> checkered(uint32_t side) {
    std::vector<uint32_t> texels;
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x)
            texels.push_back((x + y) % 2 ? 0xff30a0e0u + 7 * x : 0xff803020u + 5 * y);
    return texels;
}

std::vector<float> sky(uint32_t width, uint32_t height) {
    std::vector<float> texels;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const float up = 1 - float(y) / float(height), round = float(x) / float(width);
            texels.insert(texels.end(), {0.2f + up, 0.4f + 0.5f * round, 1.5f - up, 1});
        }
    return texels;
}

Mesh box(Float3 low, Float3 high) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(
            {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return mesh;
}

Mesh floor_mesh() {
    Mesh mesh;
    mesh.vertices = {{-6, 0, -6}, {6, 0, -6}, {-6, 0, 6}, {6, 0, 6}};
    mesh.indices = {0, 2, 1, 1, 2, 3};
    return mesh;
}

void add_materials(Scene& scene, uint32_t checker) {
    rsh_material floor = matte({0.9f, 0.9f, 0.9f});
    floor.texture = checker;
    rsh_material mirror = matte({0.05f, 0.05f, 0.05f});
    mirror.reflection = rgb({0.8f, 0.75f, 0.7f});
    mirror.specular = rgb({0.6f, 0.6f, 0.6f}, 40);
    rsh_material glass = matte({});
    glass.reflection = rgb({0.02f, 0.02f, 0.02f});
    glass.transmission = rgb({0.9f, 0.95f, 0.9f}, 1.5f);
    glass.specular = rgb({0.5f, 0.5f, 0.5f}, 80);
    rsh_material red = matte({0.8f, 0.2f, 0.1f});
    red.specular = rgb({0.3f, 0.3f, 0.3f}, 12);
    red.emission = rgb({0.05f, 0.0f, 0.02f});
    scene.materials = {floor, mirror, glass, red};
}

}  // namespace

void Scene::add(const Mesh& part, uint32_t material, const std::vector<Float3>* part_normals) {
    const uint32_t first = uint32_t(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const uint32_t index : part.indices) mesh.indices.push_back(first + index);
    for (const Float3& v : part.vertices) texcoords.push_back({0.4f * v.x, 0.4f * v.z});
    normals.resize(mesh.vertices.size());  // zero: flat
    if (part_normals)
        std::copy(part_normals->begin(), part_normals->end(), normals.begin() + first);
    material_ids.resize(mesh.triangle_count(), material);
}

uint32_t Scene::add_texture(uint32_t width, uint32_t height,
                            const std::vector<uint32_t>& srgb8) {
    textures.push_back(
        {cl_uint(texels.size()), width, height, RSH_TEXEL_SRGB8, RSH_WRAP_REPEAT, {}});
    texels.insert(texels.end(), srgb8.begin(), srgb8.end());
    return uint32_t(textures.size()) - 1;
}

uint32_t Scene::add_texture(uint32_t width, uint32_t height, const std::vector<float>& rgba) {
    textures.push_back(
        {cl_uint(texels.size()), width, height, RSH_TEXEL_FLOAT32, RSH_WRAP_REPEAT, {}});
    for (const float value : rgba) {
        uint32_t word;
        std::memcpy(&word, &value, 4);
        texels.push_back(word);
    }
    return uint32_t(textures.size()) - 1;
}

rsh_material matte(Float3 diffuse) {
    rsh_material material = {};
    material.ambient = material.diffuse = rgb(diffuse);
    material.specular.s[3] = 1;
    material.transmission.s[3] = 1;
    material.texture = RSH_NO_TEXTURE;
    return material;
}

rsh_light point_light(Float3 position, Float3 colour) {
    rsh_light light = {};
    light.kind = RSH_LIGHT_POINT;
    light.position = rgb(position);
    light.colour = rgb(colour);
    light.casts_shadow = 1;
    return light;
}

rsh_light directional_light(Float3 direction, Float3 colour) {
    rsh_light light = point_light({}, colour);
    light.kind = RSH_LIGHT_DIRECTIONAL;
    light.direction = rgb(normalize(direction));
    return light;
}

rsh_light spot_light(Float3 position, Float3 direction, Float3 colour) {
    rsh_light light = directional_light(direction, colour);
    light.kind = RSH_LIGHT_SPOT;
    light.position = rgb(position);
    light.cos_inner = 0.95f;
    light.cos_outer = 0.8f;
    return light;
}

rsh_camera look_at(Float3 eye, Float3 at, uint32_t width, uint32_t height) {
    const Float3 forward = normalize(at - eye);
    const Float3 right = normalize(cross(forward, Float3(0, 1, 0)));
    const Float3 up = cross(right, forward);
    rsh_camera camera = {};
    camera.eye = rgb(eye, 1e-3f);
    camera.forward = rgb(forward);
    camera.right = rgb((0.5f * float(width) / float(height)) * right);
    camera.up = rgb(0.5f * up);
    return camera;
}

Scene gallery() {
    Scene scene;
    add_materials(scene, scene.add_texture(8, 8, checkered(8)));
    scene.environment_texture = 1 + scene.add_texture(16, 8, sky(16, 8));
    scene.environment = {1, 1, 1};
    scene.add(floor_mesh(), 0, nullptr);
    const Float3 mirror_at(-1.1f, 1, 0), glass_at(1.2f, 0.9f, 1);
    const Mesh mirror = scaled(sphere(48, 23), 1, mirror_at);
    const Mesh glass = scaled(sphere(48, 23), 0.8f, glass_at);
    const auto mirror_normals = radial_normals(mirror, mirror_at);
    const auto glass_normals = radial_normals(glass, glass_at);
    scene.add(mirror, 1, &mirror_normals);
    scene.add(glass, 2, &glass_normals);
    scene.add(box({0.4f, 0.01f, -2}, {1.6f, 1.2f, -1}), 3, nullptr);
    rsh_light lamp = point_light({2, 5, 3}, {14, 13, 12});
    lamp.attenuation = {{1, 0.1f, 0.4f, 0}};
    rsh_light sun = directional_light({0.3f, -1, -0.4f}, {0.25f, 0.25f, 0.3f});
    sun.casts_shadow = 0;
    scene.lights = {lamp, sun, spot_light({-3, 4, 2}, {0.6f, -1, -0.5f}, {0.6f, 0.5f, 0.4f})};
    return scene;
}

Scene plain() {
    Scene scene;
    scene.materials = {matte({0.7f, 0.6f, 0.5f})};
    scene.add(floor_mesh(), 0, nullptr);
    scene.add(scaled(sphere(24, 11), 1, {0, 1, 0}), 0, nullptr);
    scene.normals.clear();
    scene.texcoords.clear();
    rsh_light lamp = point_light({2, 5, 3}, {0.8f, 0.8f, 0.8f});
    lamp.casts_shadow = 0;
    scene.lights = {lamp};
    return scene;
}

Scene mirror_scene(const Mesh& mesh) {
    Scene scene = plain();
    scene.materials[0].reflection = {{0.5f, 0.5f, 0.5f, 0}};
    scene.lights[0].casts_shadow = 1;
    scene.mesh = mesh;
    scene.material_ids.assign(mesh.triangle_count(), 0);
    return scene;
}

}  // namespace test
