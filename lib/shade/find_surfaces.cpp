#include "shade/find_surfaces.hpp"

#include "mesh/mesh.hpp"
#include "shade/surface_kernel.hpp"

namespace rsh {

void find_surfaces(Recorder& recorder, const rsh_find_surfaces_desc& desc) {
    const rsh_scene& scene = *desc.scene;
    // A work-item finds sixteen at once where it has vectors for them.
    const size_t per_item = recorder.context().vector_width > 1 ? 16 : 1;
    recorder.launch(RSH_STAGE_SHADE, surface_kernel(scene, "rsh_find_surfaces"),
                    recorder.range((size_t{desc.ray_count} + per_item - 1) / per_item),
                    mesh_view_of(scene), scene.geometry.vertices, scene.geometry.indices,
                    scene.normals, scene.texcoords, scene.material_ids, scene.materials,
                    scene.material_count, scene.textures, scene.texture_count, scene.texels,
                    desc.ray_count, desc.list_count, desc.rays, desc.hits, desc.surfaces);
}

}  // namespace rsh
