#include "passes/spawn.hpp"

#include "passes/mesh.hpp"

namespace rsh {
namespace {

// Rays that one work-item makes: enough that counting them costs one atomic among many rays,
// few enough that a screen fills a GPU.
constexpr size_t kRaysPerItem = 16;

std::string define(const char* name, bool value) {
    return std::string(" -D ") + name + (value ? "=1" : "=0");
}

std::string smooth_option(const rsh_scene& scene) {
    return define("RSH_SMOOTH_NORMAL", scene.features & RSH_FEATURE_SMOOTH_NORMAL);
}

// A refracted ray's kernel always knows transmission, a mirror ray's only for Fresnel's share.
std::string options_of(const rsh_spawn_desc& desc) {
    const bool is_refracted = desc.kind == RSH_SPAWN_REFRACTION;
    const bool transmits = desc.scene->features & RSH_FEATURE_REFRACTION;
    return smooth_option(*desc.scene) + define("RSH_REFRACTED", is_refracted) +
           define("RSH_TRANSMISSION", is_refracted || transmits);
}

void spawn_shadow(Recorder& recorder, const rsh_spawn_desc& desc, const Range& range) {
    const rsh_scene& scene = *desc.scene;
    recorder.launch(RSH_STAGE_SPAWN, {"spawn_shadow", "rsh_spawn_shadow", smooth_option(scene)},
                    range, mesh_of(scene.geometry), scene.geometry.vertices,
                    scene.geometry.indices, scene.normals, scene.material_ids, scene.materials,
                    scene.material_count, scene.lights, desc.light, desc.ray_count, desc.rays,
                    desc.hits, desc.spawned_rays, desc.active_count);
}

}  // namespace

void spawn(Recorder& recorder, const rsh_spawn_desc& desc) {
    const Range range =
        recorder.range((size_t{desc.ray_count} + kRaysPerItem - 1) / kRaysPerItem);
    if (desc.kind == RSH_SPAWN_SHADOW) return spawn_shadow(recorder, desc, range);
    const rsh_scene& scene = *desc.scene;
    recorder.launch(RSH_STAGE_SPAWN, {"spawn", "rsh_spawn", options_of(desc)}, range,
                    mesh_of(scene.geometry), scene.geometry.vertices, scene.geometry.indices,
                    scene.normals, scene.material_ids, scene.materials, scene.material_count,
                    desc.ray_count, desc.min_weight, desc.rays, desc.hits, desc.weights,
                    desc.spawned_rays, desc.spawned_weights, desc.active_count);
}

}  // namespace rsh
