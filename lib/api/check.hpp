// check.hpp - every argument is checked here before anything is enqueued. A complaint names the
// field, its actual and its required value.
#pragma once

#include <rsh/rsh.h>

#include <type_traits>

#include "api/struct_size.hpp"
#include "device/cl/context.hpp"
#include "device/error.hpp"

namespace rsh {

// `actual` stands for the field's value in the message, `required` are the parts of what it must
// be.
template <class Number, class... Required>
void require(bool holds, const char* field, Number actual, const Required&... required) {
    if (!holds)
        throw Error(RSH_INVALID_VALUE, field, ": is ", actual, ", must be ", required...);
}

void require_not_null(const void* pointer, const char* field);

template <class Struct>
void check_struct(const Struct* callers, const char* name, const char* size_field) {
    require_not_null(callers, name);
    const size_t given = callers->struct_size, first = FirstVersion<Struct>::bytes;
    if (first == sizeof(Struct))
        require(given == first, size_field, given, first);
    else
        require(is_known_size<Struct>(given), size_field, given, first, " .. ", sizeof(Struct));
}

template <class Desc, class = void>
constexpr bool kHasScene = false;
template <class Desc>
constexpr bool kHasScene<Desc, std::void_t<decltype(Desc::scene)>> = true;

template <class Desc, class = void>
constexpr bool kHasBatches = false;
template <class Desc>
constexpr bool kHasBatches<Desc, std::void_t<decltype(Desc::batches)>> = true;

// A caller's descriptor, and the scene and source of batches that it points to, at this version's size.
template <class Desc>
class Received {
public:
    explicit Received(const Desc* callers, const char* name = "desc",
                      const char* size_field = "struct_size") {
        check_struct(callers, name, size_field);
        desc_ = widened(callers);
        if constexpr (kHasScene<Desc>) take_scene();
        if constexpr (kHasBatches<Desc>) take_batches();
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

    void take_batches() {
        if (!desc_.batches) return;
        check_struct(desc_.batches, "batches", "batches.struct_size");
        batches_ = widened(desc_.batches);
        desc_.batches = &batches_;
    }

    Desc desc_;
    rsh_scene scene_ = {};
    rsh_batch_source batches_ = {};
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
void check_shape(const rsh_trace_desc& desc);
void check_shape(const rsh_audit_desc& desc);
void check_shape(const rsh_spawn_desc& desc);
void check_shape(const rsh_spawn_wave_desc& desc);
void check_shape(const rsh_gather_wave_desc& desc);
void check_shape(const rsh_shadow_desc& desc);
void check_shape(const rsh_find_surfaces_desc& desc);
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
void check_buffers(const Context& context, const rsh_trace_desc& desc);
void check_buffers(const Context& context, const rsh_audit_desc& desc);
void check_buffers(const Context& context, const rsh_spawn_desc& desc);
void check_buffers(const Context& context, const rsh_spawn_wave_desc& desc);
void check_buffers(const Context& context, const rsh_gather_wave_desc& desc);
void check_buffers(const Context& context, const rsh_shadow_desc& desc);
void check_buffers(const Context& context, const rsh_find_surfaces_desc& desc);
void check_buffers(const Context& context, const rsh_shade_desc& desc);
void check_buffers(const Context& context, const rsh_frame_desc& desc);
void check_buffers(const Context& context, const rsh_reduce_desc& desc);

}  // namespace rsh
