// scene_schema.cpp - scene, mesh, material, environment and settings objects.
#include "scene/scene_schema.hpp"

#include <fmt/format.h>
#include <rsh/rsh.h>

#include "files/file_search.hpp"
#include "scene/motion_schema.hpp"
#include "scene/view/view_schema.hpp"

namespace render {
namespace {

constexpr double kHuge = 1e30;

RoomOptions room(const JsonValue& value) {
    value.allow_keys({"generator", "triangles", "mirror", "glass", "seed", "transform",
                      "material", "materials"});
    value.member("generator").one_of({"room"});
    RoomOptions options;
    if (auto v = value.find("triangles"))
        options.triangles = v->integer_in(kMinRoomTriangles, kMaxRoomTriangles);
    if (auto v = value.find("mirror")) {
        const std::string mirror = v->one_of({"none", "sphere", "floor", "both"});
        options.mirror_sphere = mirror == "sphere" || mirror == "both";
        options.mirror_floor = mirror == "floor" || mirror == "both";
    }
    if (auto v = value.find("glass")) options.glass = v->boolean();
    if (auto v = value.find("seed")) options.seed = v->integer_in(0, UINT32_MAX);
    return options;
}

uint32_t cut(const JsonValue& value) {
    const std::string name = value.one_of({"black", "ambient", "environment"});
    return name == "black"     ? RSH_CUT_BLACK
           : name == "ambient" ? RSH_CUT_AMBIENT
                               : RSH_CUT_ENVIRONMENT;
}

SceneSettings settings(const JsonValue& value) {
    value.allow_keys({"size", "bounces", "min_weight", "cut", "frames", "time", "still"});
    SceneSettings settings;
    if (auto v = value.find("size")) {
        const auto sides = v->items();
        if (sides.size() != 2) v->fail("an array of width and height");
        settings.size =
            glm::uvec2(sides[0].integer_in(1, 16384), sides[1].integer_in(1, 16384));
    }
    if (auto v = value.find("bounces")) settings.bounces = v->integer_in(0, RSH_MAX_LEVELS);
    if (auto v = value.find("min_weight")) settings.min_weight = v->number_in(0, 1);
    if (auto v = value.find("cut")) settings.cut = cut(*v);
    if (auto v = value.find("frames")) settings.frames = v->integer_in(1, 1000000);
    if (auto v = value.find("still")) settings.still = v->number();
    if (auto v = value.find("time")) {
        const auto ends = v->items();
        if (ends.size() != 2) v->fail("an array of start and end");
        settings.time = Interval{ends[0].number(), ends[1].number()};
        if (settings.time->end < settings.time->start)
            v->fail("a start that is not after the end");
    }
    return settings;
}

}  // namespace

std::string SceneSchema::file(const JsonValue& value) const {
    return find_file(value.text(), folders_, value.where());
}

MaterialChange SceneSchema::material(const JsonValue& value) const {
    value.allow_keys({"ambient", "diffuse", "specular", "shininess", "reflection",
                      "transmission", "ior", "emission", "texture"});
    const auto colour = [&](const char* key) {
        const auto found = value.find(key);
        return found ? std::optional(found->colour()) : std::nullopt;
    };
    MaterialChange change;
    change.ambient = colour("ambient");
    change.diffuse = colour("diffuse");
    change.specular = colour("specular");
    change.reflection = colour("reflection");
    change.transmission = colour("transmission");
    change.emission = colour("emission");
    if (auto v = value.find("shininess")) change.shininess = v->number_in(0, 1e6);
    if (auto v = value.find("ior")) change.ior = v->number_in(0.01, 100);
    if (auto v = value.find("texture")) change.texture = file(*v);
    return change;
}

MeshEntry SceneSchema::mesh_from_file(const JsonValue& value) const {
    value.allow_keys({"file", "vertex_frames", "clip", "smooth", "repeat", "transform", "stand",
                      "keys", "material", "materials"});
    MeshEntry entry;
    entry.file = file(value.member("file"));
    if (auto v = value.find("vertex_frames")) entry.vertex_frames = file(*v);
    if (auto v = value.find("clip")) entry.clip = v->text();
    if (auto v = value.find("smooth")) {
        entry.is_smooth = v->is_number() || v->boolean();
        if (v->is_number()) entry.crease_degrees = v->number_in(0, 180);
    }
    if (auto v = value.find("repeat")) entry.repeats = v->boolean();
    if (auto v = value.find("keys")) entry.keys = rigid_keys(*v);
    if (auto v = value.find("stand")) {
        v->allow_keys({"at", "height"});
        entry.stand = Stand{v->member("at").vec3(),
                            static_cast<float>(v->member("height").number_in(1e-30, kHuge))};
    }
    return entry;
}

MeshEntry SceneSchema::mesh(const JsonValue& value) const {
    MeshEntry entry;
    if (value.is_object() && value.has("generator"))
        entry.room = room(value);
    else
        entry = mesh_from_file(value);
    entry.where = value.where();
    if (auto v = value.find("transform")) entry.transform = transform(*v);
    if (auto v = value.find("material")) entry.material = material(*v);
    if (auto v = value.find("materials"))
        for (const std::string& name : v->keys()) {
            const JsonValue named = v->member(name);
            entry.materials[name] = material(named);
        }
    return entry;
}

Environment SceneSchema::environment(const JsonValue& value) const {
    value.allow_keys({"colour", "image"});
    Environment environment;
    if (auto v = value.find("image")) {
        environment.image = file(*v);
        environment.colour = glm::vec3(1.0f);
    }
    if (auto v = value.find("colour")) environment.colour = v->colour();
    return environment;
}

SceneDescription SceneSchema::scene(const JsonValue& value) const {
    value.allow_keys(
        {"description", "meshes", "camera", "lights", "ambient", "environment", "settings"});
    SceneDescription scene;
    if (auto v = value.find("description")) v->text();
    for (const JsonValue& item : value.member("meshes").items())
        scene.meshes.push_back(mesh(item));
    if (auto v = value.find("camera")) scene.camera = scene_camera(*v);
    if (auto v = value.find("lights")) scene.lights = scene_lights(*v);
    if (auto v = value.find("ambient")) scene.ambient = v->colour();
    if (auto v = value.find("environment")) scene.environment = environment(*v);
    if (auto v = value.find("settings")) scene.settings = settings(*v);
    return scene;
}

}  // namespace render
