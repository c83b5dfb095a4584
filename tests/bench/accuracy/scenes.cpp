#include "accuracy/scenes.hpp"

#include <cstring>

#include "scene/device_structs.hpp"

namespace bench::accuracy {
namespace {

// Packed vectors of one library as those of another.
template <class To, class From>
std::vector<To> copied(const std::vector<From>& from) {
    static_assert(sizeof(From) % sizeof(To) == 0, "whole items");
    std::vector<To> to(from.size() * (sizeof(From) / sizeof(To)));
    if (!to.empty())
        std::memcpy(static_cast<void*>(to.data()), from.data(), from.size() * sizeof(From));
    return to;
}

// A floor with a texture, a mirror, glass, a box, three lights and a sky: the scene of the tests.
Staged spheres() {
    return {test::gallery(), test::look_at({0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, 4, 3)};
}

}  // namespace

SceneKind room_kind(const char* name, int64_t triangles, bool is_quick) {
    return {name, is_quick, [=] {
                Staged room =
                    staged(make_still_room({name, Reflector::kSeveral, triangles, "", false}));
                room.scene.ambient = {0.12f, 0.12f, 0.12f};
                return room;
            }};
}

SceneKind file_kind(const char* name, bool is_quick) {
    const std::string file = std::string(RSH_SCENE_FILES "/") + name + ".json";
    return {name, is_quick, [=] { return read_staged(file); }};
}

const std::vector<SceneKind>& scene_kinds() {
    static const std::vector<SceneKind> all = {
        {"spheres", true, spheres}, room_kind("room_20k", 20000), room_kind("room_80k", 80000),
        file_kind("quickstart"),    file_kind("gallery"),         file_kind("kitchen"),
        file_kind("museum3"),
    };
    return all;
}

Staged staged(const StillScene& still) {
    Staged made;
    test::Scene& scene = made.scene;
    scene.mesh.vertices = copied<test::Float3>(still.mesh.positions);
    scene.mesh.indices = copied<uint32_t>(still.mesh.triangles);
    scene.normals = copied<test::Float3>(still.mesh.normals);
    scene.texcoords = copied<std::array<float, 2>>(still.mesh.texcoords);
    scene.material_ids = still.mesh.material_ids;
    scene.materials = still.materials;
    for (const render::Light& light : still.lights)
        scene.lights.push_back(render::device_light(light));
    scene.environment = {0, 0, 0};
    made.camera = render::device_camera(still.camera, kAspect);
    return made;
}

}  // namespace bench::accuracy
