// scene.hpp - a scene on the host with everything that shading reads, and the few scenes that the tests
// of shading, frames and images and rsh-bench accuracy share. Knows no device.
#pragma once

#include <array>
#include <vector>

#include <rsh/rsh.h>

#include "support/mesh.hpp"

namespace test {

struct Scene {
    Mesh mesh;
    std::vector<Float3> normals;                  // empty, or one per vertex
    std::vector<std::array<float, 2>> texcoords;  // empty, or one per vertex
    std::vector<uint32_t> material_ids;           // empty, or one per triangle
    std::vector<rsh_material> materials;
    std::vector<rsh_light> lights;
    std::vector<rsh_texture> textures;
    std::vector<uint32_t> texels;
    Float3 ambient{0.1f, 0.1f, 0.1f};
    Float3 environment{0.2f, 0.3f, 0.5f};
    uint32_t environment_texture = 0;
    uint32_t cut = RSH_CUT_BLACK;

    // Appends `part` with one material; with normals when the scene has some, flat ones if
    // null.
    void add(const Mesh& part, uint32_t material, const std::vector<Float3>* part_normals);
    uint32_t add_texture(uint32_t width, uint32_t height, const std::vector<uint32_t>& srgb8);
    uint32_t add_texture(uint32_t width, uint32_t height, const std::vector<float>& rgba);
};

rsh_material matte(Float3 diffuse);
rsh_light point_light(Float3 position, Float3 colour);
rsh_light directional_light(Float3 direction, Float3 colour);
rsh_light spot_light(Float3 position, Float3 direction, Float3 colour);

// Looks from `eye` to `at`; vertical field of view about 53 degrees.
rsh_camera look_at(Float3 eye, Float3 at, uint32_t width, uint32_t height);

// Floor with a checkered texture, a mirror sphere, a glass sphere, a matte box; a point light
// with shadow and attenuation, a directional and a spot light; an environment image.
Scene gallery();

// Matte, flat, one light without shadow: needs no feature.
Scene plain();

// A mesh of mirrors and a light with shadow, so that rays are traced.
Scene mirror_scene(const Mesh& mesh);

}  // namespace test
