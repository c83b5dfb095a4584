// check.hpp - every argument is checked here before anything is enqueued. A complaint names the
// field, its actual and its required value.
#pragma once

#include <rsh/rsh.h>

#include <string>

#include "cl/context.hpp"
#include "core/error.hpp"

namespace rsh {

// `actual` stands for the field's value in the message; any type that std::to_string takes.
template <class Number>
void require(bool holds, const char* field, Number actual, const std::string& required) {
    if (!holds)
        throw Error(RSH_INVALID_VALUE, std::string(field) + ": is " + std::to_string(actual) +
                                           ", must be " + required);
}

void require_not_null(const void* pointer, const char* field);

// Dereferences a descriptor of exactly this version's size.
template <class Desc>
Desc checked_desc(const Desc* desc) {
    require_not_null(desc, "desc");
    require(desc->struct_size == sizeof(Desc), "struct_size", desc->struct_size,
            std::to_string(sizeof(Desc)));
    return *desc;
}

Context& checked_context(rsh_context context);
// A grid, or a list when height is 0 or 1.
void check_ray_grid(cl_uint width, cl_uint height);
void check_submission(const Context& context, cl_command_queue queue, cl_uint wait_count,
                      const cl_event* wait_list);
// A buffer of the context that holds at least `bytes`; may be NULL only if `bytes` is 0.
void check_buffer(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes);
// The same for scratch memory, where NULL means the pool.
void check_scratch(const Context& context, cl_mem scratch, size_t bytes);

void check(const Context& context, const rsh_geometry& geometry);
void check(const Context& context, const rsh_scene* scene);
void check(const Context& context, const rsh_rasterize_desc& desc);
void check(const Context& context, const rsh_bound_desc& desc);
void check(const Context& context, const rsh_build_desc& desc);
void check(const Context& context, const rsh_traverse_desc& desc);
void check(const Context& context, const rsh_spawn_desc& desc);
void check(const Context& context, const rsh_shade_desc& desc);
void check(const Context& context, const rsh_frame_desc& desc);
void check(const Context& context, const rsh_reduce_desc& desc);

}  // namespace rsh
