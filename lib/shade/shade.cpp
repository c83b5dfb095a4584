#include "shade/shade.hpp"

#include "mesh/mesh.hpp"
#include "shade/surface_kernel.hpp"

namespace rsh {
namespace {

// A work-item shades sixteen rays at once where it has vectors for them, and one ray elsewhere.
size_t items_for(Recorder& recorder, size_t rays) {
    return recorder.context().vector_width > 1 ? (rays + 15) / 16 : rays;
}

void shade(Recorder& recorder, const rsh_shade_desc& desc, bool is_first) {
    const rsh_scene& scene = *desc.scene;
    recorder.launch(RSH_STAGE_SHADE, surface_kernel(scene, "rsh_shade"),
                    recorder.range(items_for(recorder, desc.ray_count)), mesh_view_of(scene),
                    scene.geometry.vertices, scene.geometry.indices, scene.normals,
                    scene.texcoords, scene.material_ids, scene.materials, scene.material_count,
                    scene.lights, scene.light_count, scene.textures, scene.texture_count,
                    scene.texels, scene.ambient, scene.environment,
                    scene.environment_texture - 1u, desc.ray_count, desc.list_count, desc.rays,
                    desc.hits, desc.weights, desc.occlusion, shadow_lights(scene),
                    cl_uint{is_first}, desc.colour);
}

}  // namespace

cl_uint shadow_lights(const rsh_scene& scene) {
    const cl_ulong lights = (cl_ulong{1} << scene.light_count) - 1;
    if (!(scene.features & RSH_FEATURE_SHADOW)) return 0;
    return scene.shadow_lights & static_cast<cl_uint>(lights);
}

void shade(Recorder& recorder, const rsh_shade_desc& desc) {
    shade(recorder, desc, false);
}

void shade_first(Recorder& recorder, const rsh_shade_desc& desc) {
    shade(recorder, desc, true);
}

void shade_lit(Recorder& recorder, const LightPass& pass) {
    const rsh_shade_desc& desc = pass.shade;
    const rsh_spawn_desc& shadow = pass.shadow;
    const rsh_scene& scene = *desc.scene;
    recorder.launch(
        RSH_STAGE_SHADE, surface_kernel(scene, "rsh_shade_lit"),
        recorder.range(items_for(recorder, desc.ray_count)), mesh_view_of(scene),
        scene.geometry.vertices, scene.geometry.indices, scene.normals, scene.texcoords,
        scene.material_ids, scene.materials, scene.material_count, scene.lights,
        scene.light_count, scene.textures, scene.texture_count, scene.texels, scene.ambient,
        scene.environment, scene.environment_texture - 1u, desc.ray_count, desc.list_count,
        desc.rays, desc.hits, desc.weights, shadow_lights(scene), shadow.light,
        cl_uint{pass.is_base}, desc.occlusion, cl_uint{pass.is_first}, desc.colour,
        shadow.spawned_rays, shadow.spawned_skip, pass.light_colour, shadow.active_count);
}

void add_light(Recorder& recorder, const LightPass& pass) {
    const rsh_shade_desc& desc = pass.shade;
    recorder.launch(RSH_STAGE_SHADE, surface_kernel(*desc.scene, "rsh_add_light"),
                    recorder.range(items_for(recorder, desc.ray_count)), desc.ray_count,
                    desc.list_count, pass.shadow.light, desc.occlusion, pass.light_colour,
                    desc.colour);
}

}  // namespace rsh
