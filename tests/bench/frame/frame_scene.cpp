// frame_scene.cpp - rooms and scene files become one mesh, a camera that sees the reflector,
// and a motion.
#include "frame/frame_scene.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "scene/scene_file.hpp"
#include "scene/world.hpp"

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

render::SceneDescription room_description(const SceneSpec& spec) {
    render::MeshEntry room;
    room.where = spec.name;
    room.room.triangles = spec.triangles;
    const bool several = spec.reflector == Reflector::kSeveral;
    const bool floor =
        spec.reflector == Reflector::kFloor || spec.reflector == Reflector::kFloor45;
    room.room.mirror_sphere = spec.reflector == Reflector::kSphere || several;
    room.room.mirror_floor = floor || several;
    room.room.glass = spec.reflector == Reflector::kGlass || several;
    if (several)
        for (const char* glaze : {"red glaze", "blue glaze", "ochre glaze", "green glaze"})
            room.materials[glaze].reflection = glm::vec3(0.3f);
    if (spec.reflector == Reflector::kFloor45)
        room.transform =
            glm::rotate(glm::mat4(1.0f), glm::radians(45.0f), glm::vec3(0.6f, 0.0f, 0.8f));
    render::SceneDescription scene;
    scene.meshes.push_back(room);
    if (spec.reflector == Reflector::kSphere)
        scene.camera = close_up({-1.75f, 1.1f, -1.3f}, {0.42f, 0.12f, 0.9f}, 3.3f);
    if (spec.reflector == Reflector::kGlass)
        scene.camera = close_up({1.15f, 0.84f, 0.7f}, {-0.35f, 0.15f, 0.92f}, 1.4f);
    return scene;
}

struct Box {
    glm::vec3 low{INFINITY}, high{-INFINITY};
};

Box box_of(const std::vector<glm::vec3>& positions) {
    Box box;
    for (const glm::vec3& p : positions) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    return box;
}

}  // namespace

FrameScene::FrameScene(const SceneSpec& spec) : is_glass_(spec.reflector == Reflector::kGlass) {
    const render::World world(spec.reflector == Reflector::kFile
                                  ? render::read_scenes({spec.file})
                                  : room_description(spec));
    mesh_ = world.mesh();
    mesh_.texcoords.clear();
    materials_ = world.materials();
    for (rsh_material& material : materials_) material.texture = RSH_NO_TEXTURE;
    lights_ = world.lights();
    camera_ = world.camera();
    make_motion(spec.is_rigid);
}

// The sway is a function of the place alone and 0.3 % of the scene's diagonal at most, so that
// triangles that share an edge keep sharing it and the picture hardly changes.
void FrameScene::make_motion(bool is_rigid) {
    const Box box = box_of(mesh_.positions);
    const float length = glm::distance(box.low, box.high);
    if (is_rigid) {
        sway_.assign(mesh_.positions.size(), 0.001f * length * glm::vec3(1.0f, 0.7f, 0.4f));
        return;
    }
    const float wave = 9.0f / length;
    for (const glm::vec3& p : mesh_.positions) {
        const glm::vec3 q = wave * (p - box.low);
        sway_.push_back(
            0.0017f * length *
            glm::vec3(std::sin(q.y + 1.0f), std::sin(q.z + 2.0f), std::sin(q.x + 3.0f)));
    }
}

void FrameScene::move(double time, std::vector<glm::vec3>& positions) const {
    const auto far = static_cast<float>(std::sin(time));
    for (size_t i = 0; i < sway_.size(); ++i)
        positions[i] = mesh_.positions[i] + far * sway_[i];
}

int FrameScene::point_light() const {
    for (size_t i = 0; i < lights_.size(); ++i)
        if (lights_[i].casts_shadow && lights_[i].kind != RSH_LIGHT_DIRECTIONAL)
            return static_cast<int>(i);
    return -1;
}

}  // namespace bench
