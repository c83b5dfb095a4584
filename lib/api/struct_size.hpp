// struct_size.hpp - how structs of the API grow: what a program built for an older header
// passes is shorter, and the members it lacks count as zero. Complains about nothing; check.hpp
// does.
//
// A struct that gains a member keeps its row below: that is the shortest size ever accepted.
// The member must start at or behind that size, never in the padding before it, which older
// programs leave undefined.
#pragma once

#include <rsh/rsh.h>

#include <cstddef>
#include <cstring>

namespace rsh {

// Size of a struct in version 0.1: up to `last_member` and padded.
template <class Struct>
struct FirstVersion;

constexpr size_t round_up(size_t bytes, size_t alignment) {
    return (bytes + alignment - 1) / alignment * alignment;
}

#define RSH_FIRST_VERSION(type, last_member)                                                  \
    template <>                                                                               \
    struct FirstVersion<type> {                                                               \
        static constexpr size_t bytes =                                                       \
            round_up(offsetof(type, last_member) + sizeof(type::last_member), alignof(type)); \
    }
RSH_FIRST_VERSION(rsh_context_desc, log_user);
RSH_FIRST_VERSION(rsh_statistics, wrong_buffers);
RSH_FIRST_VERSION(rsh_scene, features);
RSH_FIRST_VERSION(rsh_sizes, scratch_bytes);
RSH_FIRST_VERSION(rsh_rasterize_desc, scratch_budget);
RSH_FIRST_VERSION(rsh_bound_desc, mode);
RSH_FIRST_VERSION(rsh_build_desc, scratch);
RSH_FIRST_VERSION(rsh_traverse_desc, progress_user);
RSH_FIRST_VERSION(rsh_trace_desc, cull);
RSH_FIRST_VERSION(rsh_batch_source, batch_triangles);
RSH_FIRST_VERSION(rsh_audit_desc, report);
RSH_FIRST_VERSION(rsh_spawn_desc, active_count);
RSH_FIRST_VERSION(rsh_spawn_wave_desc, scratch);
RSH_FIRST_VERSION(rsh_gather_wave_desc, list_count);
RSH_FIRST_VERSION(rsh_shadow_desc, active_count);
RSH_FIRST_VERSION(rsh_find_surfaces_desc, list_count);
RSH_FIRST_VERSION(rsh_shade_desc, colour);
RSH_FIRST_VERSION(rsh_frame_desc, audit);
RSH_FIRST_VERSION(rsh_reduce_desc, scratch);
RSH_FIRST_VERSION(rsh_prepare_desc, progress_user);
RSH_FIRST_VERSION(rsh_selftest, first_failure);
#undef RSH_FIRST_VERSION

// Not more than this version's size either: what lies behind may be a wish that it cannot
// fulfil.
template <class Struct>
constexpr bool is_known_size(size_t bytes) {
    return bytes >= FirstVersion<Struct>::bytes && bytes <= sizeof(Struct);
}

// A caller's struct of a known size, at this version's size.
template <class Struct>
Struct widened(const Struct* callers) {
    Struct copy = {};
    std::memcpy(&copy, callers, callers->struct_size);
    copy.struct_size = sizeof copy;
    return copy;
}

// Writes the members that the caller's struct has.
template <class Struct>
void hand_back(const Struct& result, Struct* callers) {
    const size_t bytes = callers->struct_size;
    std::memcpy(callers, &result, bytes);
    callers->struct_size = bytes;
}

}  // namespace rsh
