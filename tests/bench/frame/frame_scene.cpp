// frame_scene.cpp - a still scene, and how its vertices sway.
#include "frame/frame_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bench {
namespace {

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

FrameScene::FrameScene(const SceneSpec& spec)
    : still_(spec.reflector == Reflector::kFile ? read_still_scene(spec)
                                                : make_still_room(spec)),
      is_glass_(spec.reflector == Reflector::kGlass) {
    still_.mesh.texcoords.clear();
    make_motion(spec.is_rigid);
}

FrameScene::FrameScene(StillScene scene, size_t still_vertices)
    : still_(std::move(scene)), is_glass_(false) {
    still_.mesh.texcoords.clear();
    make_motion(false);
    std::fill_n(sway_.begin(), still_vertices, glm::vec3(0.0f));
}

// The sway is a function of the place alone and 0.3 % of the scene's diagonal at most, so that
// triangles that share an edge keep sharing it and the picture hardly changes.
void FrameScene::make_motion(bool is_rigid) {
    const Box box = box_of(still_.mesh.positions);
    const float length = glm::distance(box.low, box.high);
    if (is_rigid) {
        sway_.assign(still_.mesh.positions.size(),
                     0.001f * length * glm::vec3(1.0f, 0.7f, 0.4f));
        return;
    }
    const float wave = 9.0f / length;
    for (const glm::vec3& p : still_.mesh.positions) {
        const glm::vec3 q = wave * (p - box.low);
        sway_.push_back(
            0.0017f * length *
            glm::vec3(std::sin(q.y + 1.0f), std::sin(q.z + 2.0f), std::sin(q.x + 3.0f)));
    }
}

void FrameScene::move(double time, std::vector<glm::vec3>& positions) const {
    const auto far = static_cast<float>(std::sin(time));
    for (size_t i = 0; i < sway_.size(); ++i)
        positions[i] = still_.mesh.positions[i] + far * sway_[i];
}

int FrameScene::point_light() const {
    for (size_t i = 0; i < still_.lights.size(); ++i)
        if (still_.lights[i].casts_shadow && still_.lights[i].kind != RSH_LIGHT_DIRECTIONAL)
            return static_cast<int>(i);
    return -1;
}

}  // namespace bench
