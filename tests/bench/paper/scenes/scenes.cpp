// scenes.cpp - the generated rooms that stand for the paper's scenes, and the way to those in files.
#include "paper/scenes/scenes.hpp"

#include <algorithm>

#include "generate/room.hpp"
#include "paper/scenes/layers.hpp"
#include "paper/scenes/statue.hpp"
#include "scene/device_structs.hpp"

namespace bench::paper {
namespace {

class GeneratedScene final : public MovingScene {
public:
    explicit GeneratedScene(StillScene scene) : scene_(std::move(scene)) {}
    StillScene at(double /*fraction*/) override { return scene_; }

private:
    StillScene scene_;
};

StillScene still(const render::Model& model) {
    StillScene scene = {model.mesh, {}, model.lights, *model.camera};
    for (const render::Material& material : model.materials)
        scene.materials.push_back(render::device_material(material, RSH_NO_TEXTURE));
    return scene;
}

render::Model plain_room(int64_t triangles) {
    render::RoomOptions options;
    options.triangles = triangles;
    options.mirror_sphere = options.mirror_floor = options.glass = false;
    return render::make_room(options);
}

// From under the ceiling on a mirror floor and the mirror ball, which see each other: many rays are
// reflected twice.
StillScene covering_room(int64_t triangles) {
    render::RoomOptions options;
    options.triangles = triangles;
    options.mirror_sphere = options.mirror_floor = true;
    options.glass = false;
    StillScene scene = still(render::make_room(options));
    scene.camera.eye = {0.6f, 3.3f, 1.9f};
    scene.camera.at = {-0.9f, 0.0f, -0.4f};
    return scene;
}

constexpr int64_t kRoomOfStatue = 20000;

StillScene statue_room(int64_t triangles) {
    const int64_t room = std::min(kRoomOfStatue, triangles / 2);
    render::Model model = plain_room(room);
    add_statue(model, triangles - room);
    StillScene scene = still(model);
    scene.camera.eye = {0.3f, 1.5f, 3.0f};
    scene.camera.at = {0.0f, 1.15f, 0.0f};
    return scene;
}

StillScene generate(const SceneKind& kind) {
    switch (kind.source) {
        case Source::kCovering:
            return covering_room(kind.triangles);
        case Source::kLayers:
            return make_layers(kind.triangles, kind.layers);
        case Source::kStatue:
            return statue_room(kind.triangles);
        case Source::kSeveral:
            return make_still_room({kind.name, Reflector::kSeveral, kind.triangles, "", false});
        default:
            return make_still_room({kind.name, Reflector::kSphere, kind.triangles, "", false});
    }
}

}  // namespace

std::unique_ptr<MovingScene> open_scene(const SceneKind& kind) {
    if (kind.source == Source::kFile) return open_scene_file(kind);
    return std::make_unique<GeneratedScene>(generate(kind));
}

}  // namespace bench::paper
