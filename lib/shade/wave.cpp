#include "shade/wave.hpp"

#include "mesh/mesh.hpp"
#include "reduce/launch.hpp"
#include "shade/surface_kernel.hpp"

namespace rsh {
namespace {

// Where work-items are lanes: enough to fill a GPU, few enough that one group adds up their counts.
constexpr size_t kRaysPerItem = 16;

Range items_of(const Context& context, cl_uint rays) {
    if (has_single_items(context)) return item_ranges(context, rays);
    const size_t group = context.caps.group_size;
    const size_t items = (size_t{rays} + kRaysPerItem - 1) / kRaysPerItem;
    return {(items + group - 1) / group * group, group};
}

void launch_pass(Recorder& recorder, const WavePass& pass, bool is_counting) {
    const rsh_scene& scene = *pass.scene;
    recorder.launch(RSH_STAGE_SPAWN, surface_kernel(scene, "rsh_wave_spawn"),
                    items_of(recorder.context(), pass.part.count), mesh_view_of(scene),
                    scene.geometry.vertices, scene.geometry.indices, scene.normals,
                    scene.material_ids, scene.materials, scene.material_count, pass.part,
                    pass.list_count, branch_kinds(scene), pass.min_weight, pass.rays, pass.hits,
                    pass.weights, pass.branches, pass.counts, cl_uint{is_counting},
                    pass.capacity, pass.spawned_counts, pass.bounce, pass.next_count,
                    pass.spawned_rays, pass.spawned_weights, pass.spawned_skip);
}

}  // namespace

cl_uint branch_kinds(const rsh_scene& scene) {
    const bool is_reflecting = scene.features & RSH_FEATURE_REFLECTION;
    const bool is_refracting = scene.features & RSH_FEATURE_REFRACTION;
    return cl_uint{is_reflecting} << RSH_REFLECTED | cl_uint{is_refracting} << RSH_REFRACTED;
}

wave_part whole_wave(cl_uint width, cl_uint height) {
    const auto squares = [](cl_uint side) {
        return (side + RSH_SCREEN_SQUARE - 1) / RSH_SCREEN_SQUARE;
    };
    if (height == 1) return {width, 1, 0, width};
    const cl_uint places =
        squares(width) * squares(height) * RSH_SCREEN_SQUARE * RSH_SCREEN_SQUARE;
    return {width, height, 0, places};
}

size_t wave_count_words(const Context& context, cl_uint width, cl_uint height) {
    return RSH_BRANCHES * items_of(context, whole_wave(width, height).count).items;
}

void count_branches(Recorder& recorder, const WavePass& pass) {
    launch_pass(recorder, pass, true);
    const Context& context = recorder.context();
    const size_t items = items_of(context, pass.part.count).items;
    recorder.launch(RSH_STAGE_REDUCE, surface_kernel(*pass.scene, "rsh_reduce_scan_counts"),
                    groups(context, 1), pass.counts, static_cast<cl_uint>(RSH_BRANCHES * items),
                    pass.spawned_counts, pass.bounce, group_words(context));
}

void spawn_branches(Recorder& recorder, const WavePass& pass) {
    launch_pass(recorder, pass, false);
}

void gather_branches(Recorder& recorder, const WavePass& pass, cl_mem next, cl_mem colour,
                     cl_mem next_count) {
    recorder.launch(RSH_STAGE_SHADE, surface_kernel(*pass.scene, "rsh_wave_gather"),
                    items_of(recorder.context(), pass.part.count), pass.part, pass.list_count,
                    pass.branches, next_count, next, colour);
}

}  // namespace rsh
