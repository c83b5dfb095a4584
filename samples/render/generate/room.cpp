// room.cpp - the room's shell, its mirrors and glass, and where its furniture stands.
#include "generate/room.hpp"

#include <algorithm>
#include <array>

#include "generate/furniture.hpp"

namespace render {
namespace {

constexpr float kHalfX = 5.0f, kHalfZ = 4.0f, kHeight = 3.6f;

enum RoomMaterial : uint32_t {
    kLightTile,
    kDarkTile,
    kWall,
    kCeiling,
    kMirror,
    kGlass,
    kPlinth,
    kWood,
    kDarkWood,
    kCloth,
    kFirstGlaze
};

Material matt(const char* name, glm::vec3 colour) {
    Material material;
    material.name = name;
    material.ambient = colour;
    material.diffuse = colour;
    return material;
}

Material glossy(const char* name, glm::vec3 colour, float specular, float shininess) {
    Material material = matt(name, colour);
    material.specular = glm::vec3(specular);
    material.shininess = shininess;
    return material;
}

Material mirror() {
    Material material = glossy("mirror", glm::vec3(0.03f), 0.8f, 400.0f);
    material.reflection = glm::vec3(0.88f, 0.9f, 0.92f);
    return material;
}

Material glass() {
    Material material = glossy("glass", glm::vec3(0.0f), 0.6f, 400.0f);
    material.transmission = glm::vec3(0.94f, 0.98f, 0.96f);
    material.ior = 1.5f;
    return material;
}

std::vector<Material> room_materials(const RoomOptions& options) {
    std::vector<Material> materials{
        glossy("light tile", {0.46f, 0.41f, 0.33f}, 0.15f, 60.0f),
        glossy("dark tile", {0.10f, 0.08f, 0.07f}, 0.15f, 60.0f),
        matt("wall", {0.44f, 0.47f, 0.46f}),
        matt("ceiling", {0.62f, 0.62f, 0.60f}),
        mirror(),
        glass(),
        glossy("plinth", {0.45f, 0.44f, 0.42f}, 0.1f, 20.0f),
        glossy("wood", {0.42f, 0.22f, 0.10f}, 0.15f, 30.0f),
        glossy("dark wood", {0.17f, 0.08f, 0.04f}, 0.2f, 40.0f),
        matt("cloth", {0.30f, 0.05f, 0.06f}),
        glossy("red glaze", {0.55f, 0.07f, 0.04f}, 0.5f, 90.0f),
        glossy("blue glaze", {0.05f, 0.13f, 0.40f}, 0.5f, 90.0f),
        glossy("ochre glaze", {0.60f, 0.36f, 0.06f}, 0.5f, 90.0f),
        glossy("green glaze", {0.07f, 0.28f, 0.14f}, 0.5f, 90.0f),
    };
    if (options.mirror_floor)
        for (const RoomMaterial tile : {kLightTile, kDarkTile})
            materials[tile].reflection = glm::vec3(0.36f);
    return materials;
}

void add_floor(Patches& patches) {
    for (int x = 0; x < 10; ++x)
        for (int z = 0; z < 8; ++z)
            add_plane(patches, {x - kHalfX, 0, z - kHalfZ}, {0, 0, 1}, {1, 0, 0},
                      (x + z) % 2 == 0 ? kLightTile : kDarkTile);
}

// Normals point into the room.
void add_shell(Patches& patches) {
    const glm::vec3 x(2 * kHalfX, 0, 0), y(0, kHeight, 0), z(0, 0, 2 * kHalfZ);
    const glm::vec3 low(-kHalfX, 0, -kHalfZ), high(kHalfX, kHeight, kHalfZ);
    add_floor(patches);
    add_plane(patches, low + y, x, z, kCeiling);
    add_plane(patches, low, x, y, kWall);
    add_plane(patches, low, y, z, kWall);
    add_plane(patches, high, -y, -x, kWall);
    add_plane(patches, high, -z, -y, kWall);
}

void add_ball_on_plinth(Patches& patches, glm::vec3 foot, float radius, float height,
                        uint32_t material) {
    const float wide = 0.6f * radius;
    add_turned(patches, foot,
               {{wide, 0.0f},
                {wide, 0.05f},
                {0.7f * wide, 0.3f * height},
                {0.7f * wide, 0.8f * height},
                {0.8f * wide, height},
                {0.0f, height}},
               kPlinth);
    add_ball(patches, foot + glm::vec3(0, height + radius, 0), radius, material);
}

// One group of furniture per 4,000 triangles, in this order, as long as there are places.
void add_furniture(Patches& patches, const RoomOptions& options) {
    const FurnitureMaterials materials{kWood, kDarkWood, kCloth, kFirstGlaze, 4};
    constexpr std::array<glm::vec3, 3> kTables{
        {{3.2f, 0, -1.6f}, {-3.3f, 0, 1.7f}, {3.4f, 0, 2.2f}}};
    constexpr std::array<float, 5> kBackShelves{-1.9f, 1.9f, 0.0f, -3.8f, 3.8f};
    constexpr std::array<float, 3> kSideShelves{-1.4f, 0.5f, 2.4f};
    Dice dice(options.seed);
    int64_t groups = std::max<int64_t>(1, options.triangles / 4000);
    for (const glm::vec3& table : kTables)
        if (groups-- > 0) add_table_with_chairs(patches, table, materials, dice);
    for (const float x : kBackShelves)
        if (groups-- > 0) add_shelf(patches, {x, 0, 0.01f - kHalfZ}, 0, materials, dice);
    for (const float z : kSideShelves)
        if (groups-- > 0) add_shelf(patches, {0.01f - kHalfX, 0, z}, 1, materials, dice);
}

Light lamp(glm::vec3 position, glm::vec3 colour) {
    Light light;
    light.position = position;
    light.colour = colour;
    return light;
}

Camera room_camera() {
    Camera camera;
    camera.eye = {0.55f, 1.5f, 3.7f};
    camera.at = {-0.15f, 0.72f, -0.4f};
    camera.vertical_degrees = 46.0f;
    camera.near = 0.01f;
    return camera;
}

}  // namespace

Model make_room(const RoomOptions& options) {
    Patches patches;
    add_shell(patches);
    if (options.mirror_sphere)
        add_ball_on_plinth(patches, {-1.75f, 0, -1.3f}, 0.8f, 0.3f, kMirror);
    if (options.glass) add_ball_on_plinth(patches, {1.15f, 0, 0.7f}, 0.34f, 0.5f, kGlass);
    add_furniture(patches, options);

    Model model;
    model.mesh = tessellate(patches, options.triangles);
    model.materials = room_materials(options);
    model.lights = {lamp({-2.6f, 3.1f, 1.9f}, {0.88f, 0.80f, 0.68f}),
                    lamp({3.6f, 3.3f, -0.6f}, {0.20f, 0.23f, 0.29f})};
    model.camera = room_camera();
    return model;
}

}  // namespace render
