#include "hits/scenes.hpp"

#include <cstring>
#include <stdexcept>

#include "frame/ray_maker.hpp"

namespace bench::hits {
namespace {

using stability::Extent;
using stability::Scene;
using test::Float3;

// Rooms are quick to trace, and errors in them are rare.
constexpr uint32_t kManyRays = 4;

test::Mesh mesh_of(const SceneOnDevice& scene) {
    const auto& triangles = scene.frame_scene().mesh().triangles;
    test::Mesh mesh;
    mesh.vertices.resize(scene.frame_scene().mesh().positions.size());
    mesh.indices.resize(3 * triangles.size());
    static_assert(sizeof(Float3) == sizeof(glm::vec3));
    std::memcpy(&mesh.vertices[0].x, scene.positions().data(),
                mesh.vertices.size() * sizeof(Float3));
    std::memcpy(mesh.indices.data(), triangles.data(),
                mesh.indices.size() * sizeof mesh.indices[0]);
    return mesh;
}

Scene room(const Device& device, int64_t triangles, RayKind kind, Extent extent) {
    const FrameScene still({"room", Reflector::kFloor, triangles, "", false});
    const SceneOnDevice scene(device, still);
    RayMaker rays(device, {extent.side, extent.side});
    rays.make(scene, kind);
    return {mesh_of(scene), {rays.rays(), extent.side, extent.side}};
}

SceneKind room_kind(int64_t triangles, RayKind kind) {
    const std::string name =
        "room_" + std::to_string(triangles / 1000) + "k_" + bench::name_of(kind);
    return {name,
            "rooms",
            true,
            kind != RayKind::kDiffuse,
            triangles == 20000,
            kind == RayKind::kDiffuse ? 1 : kManyRays,
            [=](const Device& device, Extent extent) {
                return room(device, triangles, kind, extent);
            }};
}

// Metres from the origin; coordinates are rounded to floats there.
SceneKind far_room_kind(const char* name, float metres) {
    return {name, "far", true, true, true, kManyRays, [=](const Device& device, Extent extent) {
                const Scene near = room(device, 20000, RayKind::kPrimary, extent);
                const Float3 offset = metres * Float3(0.6f, 0.0f, 0.8f);
                return Scene{test::scaled(near.mesh, 1, offset),
                             test::scaled(near.rays, 1, offset)};
            }};
}

// Of rsh-bench stability, but larger. Embree takes no coordinates beyond 1.8e18, nor directions: Debian's
// ends the program at them.
SceneKind family_kind(const char* name, const char* group, bool is_closed = false) {
    for (const stability::Family& family : stability::all_families()) {
        if (std::strcmp(family.name, name) != 0) continue;
        return {name, group, is_closed, false, true, 1, [=](const Device&, Extent extent) {
                    test::Random random(1);
                    return family.make(random, extent);
                }};
    }
    throw std::invalid_argument(std::string("no family is called ") + name);
}

// Long ones right across the scene, so that boxes hardly help anybody: a tenth of them is as slow.
SceneKind thin_kind(const char* name) {
    SceneKind kind = family_kind(name, "thin");
    kind.make = [make = kind.make](const Device& device, Extent extent) {
        return make(device, {extent.side, extent.triangles / 10});
    };
    return kind;
}

}  // namespace

const std::vector<SceneKind>& scene_kinds() {
    static const std::vector<SceneKind> all = {
        room_kind(20000, RayKind::kPrimary),
        room_kind(20000, RayKind::kReflection),
        room_kind(20000, RayKind::kDiffuse),
        room_kind(80000, RayKind::kPrimary),
        room_kind(80000, RayKind::kReflection),
        room_kind(80000, RayKind::kDiffuse),
        thin_kind("needles"),
        thin_kind("slivers"),
        thin_kind("caps"),
        family_kind("watertight_inside", "edges", true),
        family_kind("watertight_outside", "edges"),
        family_kind("lattice_room", "edges", true),
        family_kind("grazing", "grazing"),
        far_room_kind("room_at_1e3", 1e3f),
        far_room_kind("room_at_1e5", 1e5f),
        family_kind("offsets", "far"),
        family_kind("corners_from_afar", "far"),
        family_kind("sizes_apart", "scales"),
        family_kind("scale_1e-20", "underflow"),
        family_kind("scale_1e-10", "scales"),
        family_kind("scale_1e10", "scales"),
    };
    return all;
}

}  // namespace bench::hits
