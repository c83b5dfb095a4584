// scene_files.cpp - scene files of samples/scenes, by rsh-render's own reader.
#include "frame/still_scene.hpp"
#include "scene/scene_file.hpp"
#include "scene/world.hpp"

namespace bench {

const bool kReadsSceneFiles = true;

StillScene read_still_scene(const SceneSpec& spec) {
    const render::World world(render::read_scenes({spec.file}));
    StillScene scene = {world.mesh(), world.materials(), world.lights(), world.camera()};
    for (rsh_material& material : scene.materials) material.texture = RSH_NO_TEXTURE;
    return scene;
}

}  // namespace bench
