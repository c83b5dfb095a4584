// scene_files.cpp - scene files of samples/scenes with their textures, by rsh-render's own reader.
#include "accuracy/scenes.hpp"
#include "scene/scene_file.hpp"
#include "scene/world.hpp"

namespace bench::accuracy {
namespace {

test::Float3 to_float3(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

}  // namespace

Staged read_staged(const std::string& file) {
    const render::SceneDescription description = render::read_scenes({file});
    const render::World world(description);
    Staged made = staged({world.mesh(), world.materials(), world.lights(), world.camera()});
    made.scene.textures = world.textures().textures();
    made.scene.texels = world.textures().texels();
    made.scene.ambient = to_float3(world.ambient());
    made.scene.environment = to_float3(world.environment());
    made.scene.environment_texture = world.environment_texture();
    made.bounces = description.settings.bounces.value_or(made.bounces);
    made.min_weight = description.settings.min_weight.value_or(made.min_weight);
    made.scene.cut = description.settings.cut.value_or(RSH_CUT_BLACK);
    return made;
}

}  // namespace bench::accuracy
