#include "passes/shade.hpp"

#include "passes/mesh.hpp"

namespace rsh {
namespace {

std::string options_of(const rsh_scene& scene) {
    const auto define = [&scene](const char* name, rsh_features bit) {
        return std::string(" -D ") + name + (scene.features & bit ? "=1" : "=0");
    };
    return define("RSH_SMOOTH_NORMAL", RSH_FEATURE_SMOOTH_NORMAL) +
           define("RSH_TEXTURE", RSH_FEATURE_TEXTURE) +
           define("RSH_ENVIRONMENT_IMAGE", RSH_FEATURE_ENVIRONMENT_IMAGE);
}

}  // namespace

void shade(Recorder& recorder, const rsh_shade_desc& desc) {
    const rsh_scene& scene = *desc.scene;
    recorder.launch(RSH_STAGE_SHADE, {"shade", "rsh_shade", options_of(scene)},
                    recorder.range(desc.ray_count), mesh_of(scene.geometry),
                    scene.geometry.vertices, scene.geometry.indices, scene.normals,
                    scene.texcoords, scene.material_ids, scene.materials, scene.material_count,
                    scene.lights, scene.light_count, scene.textures, scene.texture_count,
                    scene.texels, scene.ambient, scene.environment,
                    scene.environment_texture - 1u, desc.ray_count, desc.rays, desc.hits,
                    desc.weights, desc.occlusion, desc.colour);
}

}  // namespace rsh
