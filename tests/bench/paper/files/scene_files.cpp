// scene_files.cpp - scene files of samples/scenes and what moves in them, by rsh-render's own reader.
#include <tuple>

#include "paper/scenes/scenes.hpp"
#include "scene/scene_file.hpp"
#include "scene/world.hpp"

namespace bench::paper {
namespace {

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

render::SceneDescription describe(const SceneKind& kind) {
    render::SceneDescription scene = render::read_scenes({kind.file});
    for (render::MeshEntry& mesh : scene.meshes)
        for (const std::string& mirror : kind.mirrors)
            if (ends_with(mesh.file, mirror)) mesh.material.reflection = glm::vec3(0.9f);
    return scene;
}

class SceneFromFile final : public MovingScene {
public:
    explicit SceneFromFile(const SceneKind& kind) : kind_(kind), world_(describe(kind)) {}

    StillScene at(double fraction) override {
        const render::Interval span = world_.time_span();
        world_.move_to(span.start + fraction * (span.end - span.start));
        StillScene scene = {world_.mesh(), world_.materials(), world_.lights(),
                            world_.camera()};
        if (kind_.eye_and_target)
            std::tie(scene.camera.eye, scene.camera.at) = *kind_.eye_and_target;
        scene.mesh.texcoords.clear();
        for (rsh_material& material : scene.materials) material.texture = RSH_NO_TEXTURE;
        return scene;
    }

private:
    SceneKind kind_;
    render::World world_;
};

}  // namespace

std::unique_ptr<MovingScene> open_scene_file(const SceneKind& kind) {
    return std::make_unique<SceneFromFile>(kind);
}

}  // namespace bench::paper
