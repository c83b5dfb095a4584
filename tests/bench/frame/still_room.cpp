// still_room.cpp - the generated room with one kind of reflector, and a camera that sees it.
#include <glm/gtc/matrix_transform.hpp>

#include "frame/still_scene.hpp"
#include "generate/room.hpp"
#include "scene/device_structs.hpp"

namespace bench {
namespace {

// Sees the ball of room.cpp fill about a quarter of the picture.
render::Camera close_up(glm::vec3 centre, glm::vec3 towards_eye, float distance) {
    render::Camera camera;
    camera.at = centre;
    camera.eye = centre + distance * glm::normalize(towards_eye);
    camera.vertical_degrees = 46.0f;
    camera.near = 0.01f;
    return camera;
}

render::RoomOptions options_of(const SceneSpec& spec) {
    const bool several = spec.reflector == Reflector::kSeveral;
    const bool floor =
        spec.reflector == Reflector::kFloor || spec.reflector == Reflector::kFloor45;
    render::RoomOptions options;
    options.triangles = spec.triangles;
    options.mirror_sphere = spec.reflector == Reflector::kSphere || several;
    options.mirror_floor = floor || several;
    options.glass = spec.reflector == Reflector::kGlass || several;
    return options;
}

// The bits are those of a mesh that a scene file transforms.
void turn(const glm::mat4& matrix, render::Model& room) {
    const auto turned = [&](glm::vec3 p) { return glm::vec3(matrix * glm::vec4(p, 1.0f)); };
    const glm::dmat3 for_normals = glm::transpose(glm::inverse(glm::dmat3(glm::mat3(matrix))));
    for (glm::vec3& position : room.mesh.positions) position = turned(position);
    for (glm::vec3& normal : room.mesh.normals) {
        const glm::dvec3 way = for_normals * glm::dvec3(normal);
        const double length = glm::length(way);
        if (length > 0.0) normal = glm::vec3(way / length);
    }
    for (render::Light& light : room.lights) light.position = turned(light.position);
    room.camera->eye = turned(room.camera->eye);
    room.camera->at = turned(room.camera->at);
    room.camera->up = glm::mat3(matrix) * room.camera->up;
}

glm::mat4 transform_of(const SceneSpec& spec) {
    const glm::mat4 none(1.0f);
    if (spec.reflector != Reflector::kFloor45) return none;
    return glm::rotate(none, glm::radians(45.0f), glm::vec3(0.6f, 0.0f, 0.8f));
}

render::Camera camera_of(const SceneSpec& spec, const render::Model& room) {
    if (spec.reflector == Reflector::kSphere)
        return close_up({-1.75f, 1.1f, -1.3f}, {0.42f, 0.12f, 0.9f}, 3.3f);
    if (spec.reflector == Reflector::kGlass)
        return close_up({1.15f, 0.84f, 0.7f}, {-0.35f, 0.15f, 0.92f}, 1.4f);
    return *room.camera;
}

}  // namespace

StillScene make_still_room(const SceneSpec& spec) {
    render::Model room = render::make_room(options_of(spec));
    turn(transform_of(spec), room);
    StillScene scene = {room.mesh, {}, room.lights, camera_of(spec, room)};
    for (render::Material& material : room.materials) {
        const bool is_glazed = material.name.find(" glaze") != std::string::npos;
        if (spec.reflector == Reflector::kSeveral && is_glazed)
            material.reflection = glm::vec3(0.3f);
        scene.materials.push_back(render::device_material(material, RSH_NO_TEXTURE));
    }
    return scene;
}

}  // namespace bench
