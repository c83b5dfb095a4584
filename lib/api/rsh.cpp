// rsh.cpp - the C boundary: checks arguments, turns exceptions into statuses, calls the passes.
// No exception leaves this file, no OpenCL call is made in it.
#include <rsh/rsh.h>

#include <cstring>

#include "api/calls.hpp"
#include "arithmetic/probe.hpp"
#include "bvh/scene_bounds.hpp"
#include "camera/rasterize.hpp"
#include "device/cl/wrong_buffers.hpp"
#include "frame/features.hpp"
#include "frame/memory.hpp"
#include "pipeline.hpp"
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "reduce/selftest.hpp"
#include "reduce/strategy.hpp"
#include "shade/find_surfaces.hpp"
#include "shade/shade.hpp"
#include "shade/spawn.hpp"
#include "shade/spawn_wave.hpp"
#include "shadow/shadow.hpp"
#include "traverse/audit.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

constexpr const char* kDefaultEngineName = "auto";

const char* status_text(rsh_status status) {
    switch (status) {
        case RSH_SUCCESS:
            return "RSH_SUCCESS: no error";
        case RSH_INVALID_VALUE:
            return "RSH_INVALID_VALUE: a field is wrong";
        case RSH_BUFFER_TOO_SMALL:
            return "RSH_BUFFER_TOO_SMALL: a buffer holds too few bytes";
        case RSH_NO_DEVICE:
            return "RSH_NO_DEVICE: no OpenCL platform or device";
        case RSH_BUILD_FAILED:
            return "RSH_BUILD_FAILED: a kernel did not compile";
        case RSH_UNSUPPORTED:
            return "RSH_UNSUPPORTED: the device lacks what the call needs";
        case RSH_OUT_OF_MEMORY:
            return "RSH_OUT_OF_MEMORY: the host is out of memory";
        case RSH_CANCELLED:
            return "RSH_CANCELLED: the progress callback asked to stop";
        case RSH_INTERNAL_ERROR:
            return "RSH_INTERNAL_ERROR: a defect of rsh";
        default:
            return opencl_error_name(status);
    }
}

template <class Choice>
const char* name_of(const Choices<Choice>& choices, cl_uint id) {
    for (const Choice* choice : choices)
        if (choice->id() == id) return choice->name();
    return nullptr;
}

// default_name: of the value 0; NULL: it has none.
template <class Choice>
cl_uint id_of(const Choices<Choice>& choices, const char* name, const char* default_name) {
    require_not_null(name, "name");
    if (default_name && std::strcmp(default_name, name) == 0) return 0;
    char known[512];
    Text list(known, sizeof known);
    if (default_name) list.add(default_name, ", ");
    for (const Choice* choice : choices) {
        if (std::strcmp(choice->name(), name) == 0) return choice->id();
        list.add(choice == &choices.front() ? "" : ", ", choice->name());
    }
    throw Error(RSH_INVALID_VALUE, "name: is \"", name, "\", must be one of ", known);
}

}  // namespace
}  // namespace rsh

extern "C" {

const char* rsh_status_string(rsh_status status) {
    const char* text = rsh::status_text(status);
    return text ? text : "unknown status";
}

const char* rsh_last_error(void) {
    return rsh::last_error();
}

cl_uint rsh_version(void) {
    return RSH_VERSION;
}

rsh_status rsh_create_context(const rsh_context_desc* desc, rsh_context* context) {
    return rsh::guarded([&] {
        rsh::require_not_null(context, "context");
        *context = nullptr;
        const rsh::Received<rsh_context_desc> received(desc);
        rsh::require_not_null(received->context, "context");
        rsh::require_not_null(received->device, "device");
        *context = new rsh_context_s(*received);
    });
}

void rsh_release_context(rsh_context context) {
    delete context;
}

rsh_status rsh_find_device(const char* name, cl_platform_id* platform, cl_device_id* device) {
    return rsh::guarded([&] {
        rsh::require_not_null(device, "device");
        const cl_device_id found = rsh::find_device(name);
        const auto its_platform = rsh::info<cl_platform_id>(found, CL_DEVICE_PLATFORM);
        *device = found;
        if (platform) *platform = its_platform;
    });
}

rsh_status rsh_count_statistics(rsh_context context, cl_bool enabled) {
    return rsh::guarded(
        [&] { rsh::checked_context(context).statistics.enable(enabled != CL_FALSE); });
}

rsh_status rsh_get_statistics(rsh_context context, rsh_statistics* statistics) {
    return rsh::guarded([&] {
        rsh::Context& checked = rsh::checked_context(context);
        rsh::check_struct(statistics, "statistics", "statistics.struct_size");
        rsh_statistics sums = checked.statistics.sum();
        sums.programs_built = checked.programs.built();
        sums.programs_loaded = checked.programs.loaded();
        sums.variants = checked.variants.made();
        sums.scratch_bytes = checked.pool.bytes();
        rsh::hand_back(sums, statistics);
    });
}

rsh_status rsh_device_status(rsh_context context, cl_command_queue queue) {
    return rsh::guarded([&] {
        rsh::Context& checked = rsh::checked_context(context);
        rsh::check_submission(checked, queue, 0, nullptr);
        rsh::require_right_buffers(rsh::take_wrong_buffers(checked, queue));
    });
}

rsh_status rsh_find_features(rsh_scene* scene, const rsh_material* materials,
                             const rsh_light* lights) {
    return rsh::guarded([&] {
        rsh::check_struct(scene, "scene", "scene.struct_size");
        if (scene->material_count) rsh::require_not_null(materials, "materials");
        if (scene->light_count) rsh::require_not_null(lights, "lights");
        rsh::require(scene->light_count <= RSH_MAX_LIGHTS, "scene.light_count",
                     scene->light_count, "at most ", RSH_MAX_LIGHTS);
        rsh::check_host_copies(*scene, materials, lights);
        rsh_scene found = rsh::widened(scene);
        rsh::find_features(found, materials, lights);
        rsh::hand_back(found, scene);
    });
}

rsh_status rsh_rasterize_query(rsh_context context, const rsh_rasterize_desc* desc,
                               rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        return rsh::sizes_of(0, rsh::rasterize_scratch(own, checked).bytes());
    });
}

rsh_status rsh_rasterize(rsh_context context, cl_command_queue queue,
                         const rsh_rasterize_desc* desc, cl_uint wait_count,
                         const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::rasterize);
}

rsh_status rsh_bound_query(rsh_context context, const rsh_bound_desc* desc, rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        const rsh::SceneBounds& bounds = rsh::bounds_for(checked.shape);
        return rsh::sizes_of(bounds.bytes(checked.geometry),
                             bounds.scratch(own, checked.geometry, checked.mode).bytes());
    });
}

rsh_status rsh_bound(rsh_context context, cl_command_queue queue, const rsh_bound_desc* desc,
                     cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::bound);
}

rsh_status rsh_build_query(rsh_context context, const rsh_build_desc* desc, rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        const rsh::NodeShape& shape = rsh::find_shape(checked.shape);
        const ray_levels levels = shape.levels(checked.width, checked.height);
        return rsh::sizes_of(shape.bytes(levels), shape.scratch(own, levels).bytes());
    });
}

rsh_status rsh_build(rsh_context context, cl_command_queue queue, const rsh_build_desc* desc,
                     cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::build);
}

rsh_status rsh_traverse_query(rsh_context context, const rsh_traverse_desc* desc,
                              rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        return rsh::sizes_of(rsh::answer_bytes(checked),
                             rsh::traverse_scratch(own, checked).bytes());
    });
}

rsh_status rsh_traverse(rsh_context context, cl_command_queue queue,
                        const rsh_traverse_desc* desc, cl_uint wait_count,
                        const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::traverse);
}

rsh_status rsh_audit(rsh_context context, cl_command_queue queue, const rsh_audit_desc* desc,
                     cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done,
                        [](rsh::Recorder& recorder, const rsh_audit_desc& checked) {
                            rsh::clear_report(recorder, checked.report);
                            rsh::audit(recorder, checked);
                        });
}

rsh_status rsh_spawn(rsh_context context, cl_command_queue queue, const rsh_spawn_desc* desc,
                     cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::spawn);
}

rsh_status rsh_spawn_wave_query(rsh_context context, const rsh_spawn_wave_desc* desc,
                                rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        return rsh::sizes_of(rsh::ray_count(checked.width, checked.height) * 8,
                             rsh::spawn_wave_scratch(own, checked).bytes());
    });
}

rsh_status rsh_spawn_wave(rsh_context context, cl_command_queue queue,
                          const rsh_spawn_wave_desc* desc, cl_uint wait_count,
                          const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::spawn_wave);
}

rsh_status rsh_gather_wave(rsh_context context, cl_command_queue queue,
                           const rsh_gather_wave_desc* desc, cl_uint wait_count,
                           const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::gather_wave);
}

rsh_status rsh_shadow_query(rsh_context context, const rsh_shadow_desc* desc,
                            rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        return rsh::sizes_of(rsh::ray_count(checked.width, checked.height) * 4,
                             rsh::shadow_scratch(own, checked).bytes());
    });
}

rsh_status rsh_shadow(rsh_context context, cl_command_queue queue, const rsh_shadow_desc* desc,
                      cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::shadow);
}

rsh_status rsh_find_surfaces(rsh_context context, cl_command_queue queue,
                             const rsh_find_surfaces_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done,
                        rsh::find_surfaces);
}

rsh_status rsh_shade(rsh_context context, cl_command_queue queue, const rsh_shade_desc* desc,
                     cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::shade);
}

rsh_status rsh_frame_query(rsh_context context, const rsh_frame_desc* desc, rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        return rsh::sizes_of(size_t{checked.width} * checked.height * sizeof(rsh_float4),
                             rsh::frame_scratch(own, checked).bytes());
    });
}

rsh_status rsh_frame(rsh_context context, cl_command_queue queue, const rsh_frame_desc* desc,
                     cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::frame);
}

rsh_status rsh_reduce_query(rsh_context context, const rsh_reduce_desc* desc,
                            rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        return rsh::sizes_of(size_t{checked.count} * checked.element_bytes,
                             rsh::reduce_scratch(own, checked).bytes());
    });
}

rsh_status rsh_reduce(rsh_context context, cl_command_queue queue, const rsh_reduce_desc* desc,
                      cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::reduce);
}

rsh_status rsh_device_selftest(rsh_context context, cl_command_queue queue,
                               rsh_selftest* report) {
    return rsh::guarded([&] {
        rsh::Context& checked = rsh::checked_context(context);
        rsh::check_submission(checked, queue, 0, nullptr);
        rsh::check_struct(report, "report", "report.struct_size");
        rsh_selftest found = {};
        rsh::selftest(checked, queue, found);
        rsh::probe_arithmetic(checked, queue, found);
        rsh::hand_back(found, report);
    });
}

cl_bool rsh_strategy_is_stable(cl_uint strategy) {
    for (const rsh::Strategy* known : rsh::strategies())
        if (known->id() == strategy) return known->is_stable() ? CL_TRUE : CL_FALSE;
    return CL_FALSE;
}

const char* rsh_arithmetic_name(cl_uint property) {
    return rsh::arithmetic_name(property);
}

const char* rsh_strategy_name(cl_uint strategy) {
    return rsh::name_of(rsh::strategies(), strategy);
}

rsh_status rsh_default_engine(rsh_context context, cl_uint* engine) {
    return rsh::guarded([&] {
        rsh::Context& checked = rsh::checked_context(context);
        rsh::require_not_null(engine, "engine");
        *engine = rsh::default_engine(checked.caps).id();
    });
}

const char* rsh_engine_name(cl_uint engine) {
    if (engine == RSH_ENGINE_DEFAULT) return rsh::kDefaultEngineName;
    return rsh::name_of(rsh::engines(), engine);
}

cl_uint rsh_engine_shape(cl_uint engine) {
    for (const rsh::Engine* known : rsh::engines())
        if (known->id() == engine) return known->node_shape();
    return RSH_SHAPE_DEFAULT;
}

const char* rsh_shape_name(cl_uint shape) {
    return rsh::name_of(rsh::node_shapes(), shape);
}

rsh_status rsh_strategy_from_name(const char* name, cl_uint* strategy) {
    return rsh::guarded([&] {
        rsh::require_not_null(strategy, "strategy");
        *strategy = rsh::id_of(rsh::strategies(), name, nullptr);
    });
}

rsh_status rsh_engine_from_name(const char* name, cl_uint* engine) {
    return rsh::guarded([&] {
        rsh::require_not_null(engine, "engine");
        *engine = rsh::id_of(rsh::engines(), name, rsh::kDefaultEngineName);
    });
}

rsh_status rsh_shape_from_name(const char* name, cl_uint* shape) {
    return rsh::guarded([&] {
        rsh::require_not_null(shape, "shape");
        *shape = rsh::id_of(rsh::node_shapes(), name, nullptr);
    });
}

}  // extern "C"
