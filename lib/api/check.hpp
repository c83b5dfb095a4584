// check.hpp - every argument is checked here before anything is enqueued. A complaint names the
// field, its actual and its required value.
#pragma once

#include <rsh/rsh.h>

#include <string>
#include <type_traits>

#include "api/struct_size.hpp"
#include "device/cl/context.hpp"
#include "device/error.hpp"

namespace rsh {

// `actual` stands for the field's value in the message; any type that std::to_string takes.
template <class Number>
void require(bool holds, const char* field, Number actual, const std::string& required) {
    if (!holds)
        throw Error(RSH_INVALID_VALUE, std::string(field) + ": is " + std::to_string(actual) +
                                           ", must be " + required);
}

void require_not_null(const void* pointer, const char* field);

template <class Struct>
void check_struct(const Struct* callers, const char* name, const char* size_field) {
    require_not_null(callers, name);
    const std::string last = std::to_string(sizeof(Struct));
    const size_t first = FirstVersion<Struct>::bytes;
    require(is_known_size<Struct>(callers->struct_size), size_field, callers->struct_size,
            first == sizeof(Struct) ? last : std::to_string(first) + " .. " + last);
}

template <class Desc, class = void>
constexpr bool kHasScene = false;
template <class Desc>
constexpr bool kHasScene<Desc, std::void_t<decltype(Desc::scene)>> = true;

// A caller's descriptor and the scene that it points to, both at this version's size.
template <class Desc>
class Received {
public:
    explicit Received(const Desc* callers) {
        check_struct(callers, "desc", "struct_size");
        desc_ = widened(callers);
        if constexpr (kHasScene<Desc>) take_scene();
    }
    Received(const Received&) = delete;
    Received& operator=(const Received&) = delete;

    const Desc& operator*() const { return desc_; }
    const Desc* operator->() const { return &desc_; }

private:
    void take_scene() {
        check_struct(desc_.scene, "scene", "scene.struct_size");
        scene_ = widened(desc_.scene);
        desc_.scene = &scene_;
    }

    Desc desc_;
    rsh_scene scene_ = {};
};

Context& checked_context(rsh_context context);
void check_submission(const Context& context, cl_command_queue queue, cl_uint wait_count,
                      const cl_event* wait_list);

// All that a query reads: everything but buffers and callbacks.
void check_shape(const rsh_geometry& geometry);
void check_shape(const rsh_scene& scene);
void check_shape(const rsh_rasterize_desc& desc);
void check_shape(const rsh_bound_desc& desc);
void check_shape(const rsh_build_desc& desc);
void check_shape(const rsh_traverse_desc& desc);
void check_shape(const rsh_audit_desc& desc);
void check_shape(const rsh_spawn_desc& desc);
void check_shape(const rsh_shade_desc& desc);
void check_shape(const rsh_frame_desc& desc);
void check_shape(const rsh_reduce_desc& desc);

// Host copies of what lies in the scene's buffers, which no other call sees.
void check_host_copies(const rsh_scene& scene, const rsh_material* materials,
                       const rsh_light* lights);

// The buffers of a descriptor whose shape was checked; see buffers.hpp.
void check_buffers(const Context& context, const rsh_rasterize_desc& desc);
void check_buffers(const Context& context, const rsh_bound_desc& desc);
void check_buffers(const Context& context, const rsh_build_desc& desc);
void check_buffers(const Context& context, const rsh_traverse_desc& desc);
void check_buffers(const Context& context, const rsh_audit_desc& desc);
void check_buffers(const Context& context, const rsh_spawn_desc& desc);
void check_buffers(const Context& context, const rsh_shade_desc& desc);
void check_buffers(const Context& context, const rsh_frame_desc& desc);
void check_buffers(const Context& context, const rsh_reduce_desc& desc);

}  // namespace rsh
