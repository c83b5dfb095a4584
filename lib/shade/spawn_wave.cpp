#include "shade/spawn_wave.hpp"

#include "device/cl/scratch.hpp"
#include "rays/levels.hpp"
#include "shade/surface_kernel.hpp"
#include "shade/wave.hpp"

namespace rsh {
namespace {

template <class Desc>
WavePass pass_of(const Desc& desc) {
    WavePass pass = {};
    pass.scene = desc.scene;
    pass.part = whole_wave(desc.width, desc.height ? desc.height : 1);
    pass.list_count = desc.list_count;
    pass.branches = desc.branches;
    return pass;
}

void find_origins(Recorder& recorder, const rsh_spawn_wave_desc& desc) {
    if (!desc.spawned_parents && !desc.spawned_pixels) return;
    const auto rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    recorder.launch(RSH_STAGE_SPAWN, surface_kernel(*desc.scene, "rsh_wave_origins"),
                    recorder.stream_range(rays), rays, desc.list_count, desc.branches,
                    desc.spawned_count, desc.pixels, desc.spawned_parents, desc.spawned_pixels);
}

}  // namespace

Layout spawn_wave_scratch(const Context& context, const rsh_spawn_wave_desc& desc) {
    Layout layout(context.caps.alignment);
    layout.add_array<cl_uint>(
        "counts", wave_count_words(context, desc.width, desc.height ? desc.height : 1));
    return layout;
}

void spawn_wave(Recorder& recorder, const rsh_spawn_wave_desc& desc) {
    recorder.fill(RSH_STAGE_OTHER, desc.spawned_count, 0, 2 * sizeof(cl_uint));
    if (ray_count(desc.width, desc.height) == 0) return;
    const Scratch scratch(recorder, spawn_wave_scratch(recorder.context(), desc), desc.scratch);
    WavePass pass = pass_of(desc);
    pass.min_weight = desc.min_weight;
    pass.rays = desc.rays;
    pass.hits = desc.hits;
    pass.weights = desc.weights;
    pass.counts = scratch["counts"];
    // Its second word is how many rays there are, the first how many are written.
    pass.bounce = 1;
    pass.spawned_counts = desc.spawned_count;
    pass.next_count = desc.spawned_count;
    pass.capacity = desc.capacity;
    pass.spawned_rays = desc.spawned_rays;
    pass.spawned_weights = desc.spawned_weights;
    pass.spawned_skip = desc.spawned_skip;
    count_branches(recorder, pass);
    spawn_branches(recorder, pass);
    find_origins(recorder, desc);
}

void gather_wave(Recorder& recorder, const rsh_gather_wave_desc& desc) {
    gather_branches(recorder, pass_of(desc), desc.spawned_colour, desc.colour,
                    desc.spawned_count);
}

}  // namespace rsh
