#include "shade/cut.hpp"

#include "mesh/mesh.hpp"
#include "shade/surface_kernel.hpp"
#include "shade/wave.hpp"

namespace rsh {
namespace {

constexpr size_t kRaysPerItem = 16;

}  // namespace

void add_cut(Recorder& recorder, const rsh_shade_desc& wave, float min_weight) {
    const rsh_scene& scene = *wave.scene;
    const bool is_ambient = scene.cut == RSH_CUT_AMBIENT;
    recorder.launch(RSH_STAGE_SHADE, surface_kernel(scene, "rsh_cut"),
                    recorder.range((size_t{wave.ray_count} + kRaysPerItem - 1) / kRaysPerItem),
                    mesh_view_of(scene), scene.geometry.vertices, scene.geometry.indices,
                    scene.normals, scene.material_ids, scene.materials, scene.material_count,
                    scene.textures, scene.texture_count, scene.texels,
                    scene.environment_texture - 1u,
                    is_ambient ? scene.ambient : scene.environment, cl_uint{is_ambient},
                    branch_kinds(scene), min_weight, wave.ray_count, wave.list_count, wave.rays,
                    wave.hits, wave.weights, wave.colour);
}

}  // namespace rsh
