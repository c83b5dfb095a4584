#include "shade/spawn.hpp"

#include "mesh/mesh.hpp"
#include "shade/surface_kernel.hpp"

namespace rsh {
namespace {

// Rays that one work-item makes: enough that counting them costs one atomic among many rays,
// few enough that a screen fills a GPU.
constexpr size_t kRaysPerItem = 16;

void spawn_shadow(Recorder& recorder, const rsh_spawn_desc& desc, const Range& range) {
    const rsh_scene& scene = *desc.scene;
    recorder.launch(RSH_STAGE_SPAWN, surface_kernel(scene, "rsh_spawn_shadow"), range,
                    mesh_view_of(scene), scene.geometry.vertices, scene.geometry.indices,
                    scene.normals, scene.material_ids, scene.materials, scene.material_count,
                    scene.lights, desc.light, desc.ray_count, desc.list_count, desc.rays,
                    desc.hits, desc.spawned_rays, desc.spawned_skip, desc.active_count);
}

}  // namespace

void spawn(Recorder& recorder, const rsh_spawn_desc& desc) {
    const Range range =
        recorder.range((size_t{desc.ray_count} + kRaysPerItem - 1) / kRaysPerItem);
    if (desc.kind == RSH_SPAWN_SHADOW) return spawn_shadow(recorder, desc, range);
    const rsh_scene& scene = *desc.scene;
    const cl_uint is_refracted = desc.kind == RSH_SPAWN_REFRACTION;
    recorder.launch(RSH_STAGE_SPAWN, surface_kernel(scene, "rsh_spawn"), range,
                    mesh_view_of(scene), scene.geometry.vertices, scene.geometry.indices,
                    scene.normals, scene.material_ids, scene.materials, scene.material_count,
                    desc.ray_count, desc.list_count, is_refracted, desc.min_weight, desc.rays,
                    desc.hits, desc.weights, desc.spawned_rays, desc.spawned_weights,
                    desc.spawned_skip, desc.active_count);
}

}  // namespace rsh
