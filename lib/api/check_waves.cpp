// check_waves.cpp - calls that go from a wave of rays to the next one, or back.
#include "api/check_fields.hpp"
#include "rays/levels.hpp"
#include "shade/spawn_wave.hpp"

namespace rsh {
namespace {

template <class Desc>
void check_wave(const Desc& desc) {
    check_shape(*desc.scene);
    check_ray_grid(desc.width, desc.height);
    check_list_count(desc);
    require(desc.capacity <= kMaxRays, "capacity", desc.capacity, "at most ", kMaxRays);
}

}  // namespace

void check_shape(const rsh_spawn_wave_desc& desc) {
    check_wave(desc);
    check_min_weight(desc.min_weight);
}

void check_buffers(const Context& context, const rsh_spawn_wave_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, *desc.scene);
    const cl_ulong rays = ray_count(desc.width, desc.height), room = desc.capacity;
    buffers.in("rays", desc.rays, rays * sizeof(rsh_ray));
    buffers.in("hits", desc.hits, rays * sizeof(rsh_hit));
    buffers.optional_in("weights", desc.weights, rays * 16);
    buffers.optional_in("list_count", desc.list_count, 4);
    buffers.optional_in("pixels", desc.pixels, rays * 4);
    buffers.out("branches", desc.branches, rays * 8);
    buffers.out("spawned_rays", desc.spawned_rays, room * sizeof(rsh_ray));
    buffers.out("spawned_weights", desc.spawned_weights, room * 16);
    buffers.out("spawned_skip", desc.spawned_skip, room * 4);
    buffers.out("spawned_count", desc.spawned_count, 8);
    buffers.optional_out("spawned_parents", desc.spawned_parents, room * 4);
    buffers.optional_out("spawned_pixels", desc.spawned_pixels, room * 4);
    buffers.scratch(desc.scratch, spawn_wave_scratch(context, desc).bytes());
}

void check_shape(const rsh_gather_wave_desc& desc) {
    check_wave(desc);
}

void check_buffers(const Context& context, const rsh_gather_wave_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, *desc.scene);
    const cl_ulong rays = ray_count(desc.width, desc.height);
    buffers.optional_in("list_count", desc.list_count, 4);
    buffers.in("branches", desc.branches, rays * 8);
    buffers.in("spawned_count", desc.spawned_count, 8);
    buffers.in("spawned_colour", desc.spawned_colour, cl_ulong{desc.capacity} * 16);
    buffers.out("colour", desc.colour, rays * 16);
}

}  // namespace rsh
