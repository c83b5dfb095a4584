// view_schema.cpp - camera and light objects, and keys that change some of their members.
#include "scene/view/view_schema.hpp"

#include <fmt/format.h>
#include <rsh/rsh.h>

#include "scene/motion_schema.hpp"

namespace render {
namespace {

constexpr double kHuge = 1e30;

void camera_members(const JsonValue& value, Camera& camera) {
    if (auto v = value.find("eye")) camera.eye = v->vec3();
    if (auto v = value.find("at")) camera.at = v->vec3();
    if (auto v = value.find("vertical_degrees"))
        camera.vertical_degrees = v->number_in(0.01, 179);
}

// To the picture's right, of any length.
glm::dvec3 right_of(const Camera& camera) {
    return glm::cross(glm::dvec3(camera.at) - glm::dvec3(camera.eye), glm::dvec3(camera.up));
}

void require_view(const Camera& camera, const JsonValue& value) {
    if (!has_length(right_of(camera)))
        value.fail("\"eye\" and \"at\" that differ, in a direction other than \"up\"");
}

std::vector<CameraKey> camera_keys(const JsonValue& value, const Camera& camera) {
    const auto read = [&](const JsonValue& item) {
        item.allow_keys({"time", "eye", "at", "vertical_degrees"});
        CameraKey key{key_time(item), camera};
        camera_members(item, key.camera);
        require_view(key.camera, item);
        return key;
    };
    const auto keys = ascending_keys<CameraKey>(value, read);
    for (size_t i = 1; i < keys.size(); ++i)
        if (passes_through_zero(right_of(keys[i - 1].camera), right_of(keys[i].camera)))
            value.items()[i].fail(
                "a key to which the camera comes from the one before without looking along "
                "\"up\" or at its own \"eye\" in between");
    return keys;
}

// Where a spot shines, if it shines at a place: that stays when the light moves.
using Target = std::optional<glm::vec3>;

Target light_position(const JsonValue& value, Light& light) {
    if (light.kind != RSH_LIGHT_DIRECTIONAL) light.position = value.member("position").vec3();
    if (light.kind == RSH_LIGHT_POINT) return std::nullopt;
    Target target;
    if (light.kind == RSH_LIGHT_SPOT && value.has("at")) target = value.member("at").vec3();
    light.direction = target ? *target - light.position : value.member("direction").direction();
    if (!has_length(light.direction))
        value.member("at").fail("a place other than \"position\"");
    return target;
}

void move_light(const JsonValue& key, Light& light, Target target) {
    if (auto v = key.find("position")) light.position = v->vec3();
    if (auto v = key.find("at")) target = v->vec3();
    if (target) light.direction = *target - light.position;
    if (auto v = key.find("direction")) light.direction = v->direction();
    if (!has_length(light.direction)) key.fail("a \"position\" other than \"at\"");
    if (auto v = key.find("colour")) light.colour = v->colour();
}

// A point has no direction, a direction no position, and only a spot can shine at a place.
void require_members_of(const JsonValue& value, uint32_t kind) {
    const auto refuse = [&](const char* key, bool is_wrong) {
        if (is_wrong && value.has(key))
            value.member(key).fail("nothing: this kind of light has none");
    };
    refuse("position", kind == RSH_LIGHT_DIRECTIONAL);
    refuse("direction", kind == RSH_LIGHT_POINT);
    refuse("at", kind != RSH_LIGHT_SPOT);
    if (value.has("at") && value.has("direction")) value.fail("either \"direction\" or \"at\"");
}

std::vector<LightKey> light_keys(const JsonValue& value, const Light& light,
                                 const Target& target) {
    const auto read = [&](const JsonValue& item) {
        item.allow_keys({"time", "position", "direction", "at", "colour"});
        require_members_of(item, light.kind);
        LightKey key{key_time(item), light};
        move_light(item, key.light, target);
        return key;
    };
    const auto keys = ascending_keys<LightKey>(value, read);
    for (size_t i = 1; i < keys.size(); ++i)
        if (passes_through_zero(keys[i - 1].light.direction, keys[i].light.direction))
            value.items()[i].fail("a direction that is not opposite to that of the key before");
    return keys;
}

SceneLight scene_light(const JsonValue& value) {
    value.allow_keys({"kind", "position", "direction", "at", "colour", "attenuation",
                      "inner_degrees", "outer_degrees", "shadow", "keys"});
    SceneLight light;
    const std::string kind = value.member("kind").one_of({"point", "directional", "spot"});
    light.kind = kind == "point"  ? RSH_LIGHT_POINT
                 : kind == "spot" ? RSH_LIGHT_SPOT
                                  : RSH_LIGHT_DIRECTIONAL;
    const Target target = light_position(value, light);
    if (auto v = value.find("colour")) light.colour = v->colour();
    if (auto v = value.find("attenuation")) light.attenuation = v->vec3();
    if (auto v = value.find("outer_degrees")) light.outer_degrees = v->number_in(0.01, 90);
    light.inner_degrees = 0.8f * light.outer_degrees;
    if (auto v = value.find("inner_degrees"))
        light.inner_degrees = v->number_in(0, light.outer_degrees);
    if (auto v = value.find("shadow")) light.casts_shadow = v->boolean();
    if (auto v = value.find("keys")) light.keys = light_keys(*v, light, target);
    return light;
}

}  // namespace

SceneCamera scene_camera(const JsonValue& value) {
    value.allow_keys({"eye", "at", "up", "vertical_degrees", "near", "keys"});
    SceneCamera camera;
    value.member("eye");
    value.member("at");
    camera_members(value, camera);
    if (auto v = value.find("up")) camera.up = v->direction();
    if (auto v = value.find("near")) camera.near = v->number_in(0, kHuge);
    require_view(camera, value);
    if (auto v = value.find("keys")) camera.keys = camera_keys(*v, camera);
    return camera;
}

std::vector<SceneLight> scene_lights(const JsonValue& value) {
    std::vector<SceneLight> list;
    for (const JsonValue& item : value.items()) list.push_back(scene_light(item));
    if (list.size() > RSH_MAX_LIGHTS)
        value.fail(fmt::format("at most {} lights", RSH_MAX_LIGHTS));
    return list;
}

}  // namespace render
