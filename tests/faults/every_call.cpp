// every_call.cpp - the calls.
#include "faults/every_call.hpp"

#include <rsh/rsh_interface.h>

#include <cstring>

namespace test {
namespace {

constexpr rsh_status kWrong = 1;  // no status of rsh's

// A function that cannot fail gives what it must.
rsh_status expect(bool holds) {
    return holds ? RSH_SUCCESS : kWrong;
}

bool is(const char* text, const char* wanted) {
    return text && std::strcmp(text, wanted) == 0;
}

rsh_context_desc context_desc() {
    rsh_context_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.context = device().context();
    desc.device = device().device();
    return desc;
}

}  // namespace

EveryCall::EveryCall() {
    for (const rsh_bound_desc& desc : {valid_.bound(), bound(RSH_BOUND_QUALITY)}) {
        rsh_bound_desc own = desc;
        if (own.bounds == valid_.bounds.get()) own.shape = RSH_SHAPE_CONE;
        RSH_CHECK(rsh_bound(rsh_.get(), queue_(), &own, 0, nullptr, nullptr));
    }
    for (const rsh_build_desc& desc : {valid_.build(), build(false)}) {
        rsh_build_desc own = desc;
        if (own.nodes == valid_.nodes.get()) own.shape = RSH_SHAPE_CONE;
        RSH_CHECK(rsh_build(rsh_.get(), queue_(), &own, 0, nullptr, nullptr));
    }
    queue_.finish();
}

std::vector<Call> EveryCall::all() const {
    std::vector<Call> calls;
    add_information(calls);
    add_contexts(calls);
    add_queries(calls);
    add_passes(calls);
    add_blocking(calls);
    return calls;
}

std::vector<rsh_hit> EveryCall::traced() const {
    const rsh_traverse_desc desc = traverse(RSH_ENGINE_TILES);
    RSH_CHECK(rsh_traverse(rsh_.get(), queue_(), &desc, 0, nullptr, nullptr));
    queue_.finish();
    return valid_.hits.read();
}

void EveryCall::finish() const {
    queue_.finish();
    if (done_) clReleaseEvent(done_);
    done_ = nullptr;
}

rsh_bound_desc EveryCall::bound(cl_uint mode) const {
    rsh_bound_desc desc = valid_.bound();
    desc.bounds = box_bounds_.get();
    desc.shape = RSH_SHAPE_BOX;
    desc.mode = mode;
    return desc;
}

rsh_build_desc EveryCall::build(bool is_list) const {
    rsh_build_desc desc = valid_.build();
    desc.nodes = (is_list ? list_nodes_ : box_nodes_).get();
    desc.shape = RSH_SHAPE_BOX;
    if (is_list) desc.width = kRays, desc.height = 1;
    return desc;
}

rsh_traverse_desc EveryCall::traverse(cl_uint engine) const {
    rsh_traverse_desc desc = valid_.traverse();
    desc.engine = engine;
    const bool takes_cones = engine == RSH_ENGINE_PAPER_FAITHFUL;
    desc.shape = takes_cones ? RSH_SHAPE_CONE : RSH_SHAPE_BOX;
    desc.nodes = (takes_cones ? valid_.nodes : box_nodes_).get();
    desc.bounds = (takes_cones ? valid_.bounds : box_bounds_).get();
    return desc;
}

rsh_trace_desc EveryCall::trace() const {
    rsh_trace_desc desc = valid_.trace();
    desc.engine = RSH_ENGINE_TILES;
    desc.rays = nullptr;
    desc.origins = {valid_.rays.get(), 0, sizeof(rsh_ray), 0};
    desc.directions = {valid_.rays.get(), 16, sizeof(rsh_ray), 0};
    desc.normals = normals_.get();
    desc.points = points_.get();
    desc.geometry_ids = ids_.get();
    return desc;
}

rsh_frame_desc EveryCall::frame() const {
    rsh_frame_desc desc = valid_.frame();
    desc.bounces = 1;
    desc.audit_rays = 3;
    desc.audit = valid_.report.get();
    return desc;
}

// Those that return no status: whatever fails, their answer is right.
void EveryCall::add_information(std::vector<Call>& calls) const {
    calls.push_back({"rsh_status_string", [] {
                         return expect(std::strncmp(rsh_status_string(RSH_OUT_OF_MEMORY),
                                                    "RSH_OUT_OF_MEMORY", 17) == 0);
                     }});
    calls.push_back({"rsh_last_error", [] { return expect(rsh_last_error() != nullptr); }});
    calls.push_back({"rsh_version", [] { return expect(rsh_version() == RSH_VERSION); }});
    calls.push_back({"rsh_describe_interface", [] {
                         return expect(rsh_describe_interface()->struct_size ==
                                       sizeof(rsh_interface));
                     }});
    calls.push_back({"rsh_strategy_is_stable", [] {
                         return expect(rsh_strategy_is_stable(RSH_STRATEGY_CHUNK) &&
                                       !rsh_strategy_is_stable(RSH_STRATEGY_ATOMIC));
                     }});
    calls.push_back(
        {"rsh_engine_shape",
         [] { return expect(rsh_engine_shape(RSH_ENGINE_PAPER_FAITHFUL) == RSH_SHAPE_CONE); }});
    calls.push_back({"rsh_strategy_name", [] {
                         return expect(is(rsh_strategy_name(RSH_STRATEGY_CHUNK), "chunk"));
                     }});
    calls.push_back({"rsh_arithmetic_name", [] {
                         return expect(is(rsh_arithmetic_name(RSH_ARITHMETIC_FMA), "fma"));
                     }});
    calls.push_back({"rsh_engine_name",
                     [] { return expect(is(rsh_engine_name(RSH_ENGINE_TILES), "tiles")); }});
    calls.push_back(
        {"rsh_shape_name", [] { return expect(is(rsh_shape_name(RSH_SHAPE_BOX), "box")); }});
    calls.push_back({"rsh_strategy_from_name", [] {
                         cl_uint value = 0;
                         return rsh_strategy_from_name("block", &value);
                     }});
    calls.push_back({"rsh_engine_from_name", [] {
                         cl_uint value = 0;
                         return rsh_engine_from_name("paper", &value);
                     }});
    calls.push_back({"rsh_default_engine", [this] {
                         cl_uint engine = 0;
                         return rsh_default_engine(rsh_.get(), &engine);
                     }});
    calls.push_back({"rsh_shape_from_name", [] {
                         cl_uint value = 0;
                         return rsh_shape_from_name("cone", &value);
                     }});
    calls.push_back({"rsh_shape_from_name of none", [] {
                         cl_uint value = 0;
                         return expect(rsh_shape_from_name("none", &value) ==
                                           RSH_INVALID_VALUE &&
                                       std::strstr(rsh_last_error(), "box, cone"));
                     }});
}

void EveryCall::add_contexts(std::vector<Call>& calls) const {
    const auto release = [this] {
        rsh_release_context(made_);
        made_ = nullptr;
    };
    const auto create = [this] {
        const rsh_context_desc desc = context_desc();
        RSH_CHECK(rsh_create_context(&desc, &made_));
    };
    calls.push_back({"rsh_create_context",
                     [this] {
                         const rsh_context_desc desc = context_desc();
                         return rsh_create_context(&desc, &made_);
                     },
                     [] {}, release});
    calls.push_back({"rsh_release_context",
                     [=] {
                         release();
                         return RSH_SUCCESS;
                     },
                     // With counts that are still read.
                     [=] {
                         create();
                         const rsh_traverse_desc desc = traverse(RSH_ENGINE_PAPER_FAITHFUL);
                         RSH_CHECK(rsh_count_statistics(made_, CL_TRUE));
                         RSH_CHECK(rsh_traverse(made_, queue_(), &desc, 0, nullptr, nullptr));
                     },
                     [this] { finish(); }});
    calls.push_back({"rsh_find_device", [] {
                         cl_device_id found = nullptr;
                         cl_platform_id platform = nullptr;
                         return rsh_find_device(nullptr, &platform, &found);
                     }});
    // The first call of a context makes its program, here from the cache or from source.
    const rsh_reduce_desc reduce = valid_.reduce();
    calls.push_back({"rsh_reduce, the first of its context",
                     [=] { return rsh_reduce(made_, queue_(), &reduce, 0, nullptr, &done_); },
                     create,
                     [=] {
                         finish();
                         release();
                     }});
}

void EveryCall::add_queries(std::vector<Call>& calls) const {
    calls.push_back(query("rsh_rasterize_query", rsh_rasterize_query, valid_.rasterize()));
    calls.push_back(query("rsh_bound_query", rsh_bound_query, bound(RSH_BOUND_FAST)));
    calls.push_back(query("rsh_build_query", rsh_build_query, build(true)));
    for (const cl_uint engine : {RSH_ENGINE_TILES, RSH_ENGINE_PAPER, RSH_ENGINE_PAPER_FAITHFUL})
        calls.push_back(query("rsh_traverse_query", rsh_traverse_query, traverse(engine)));
    calls.push_back(query("rsh_trace_query", rsh_trace_query, trace()));
    calls.push_back(query("rsh_spawn_wave_query", rsh_spawn_wave_query, valid_.spawn_wave()));
    calls.push_back(query("rsh_shadow_query", rsh_shadow_query, valid_.shadow()));
    calls.push_back(query("rsh_frame_query", rsh_frame_query, frame()));
    calls.push_back(query("rsh_frame_query", rsh_frame_query, valid_.frame_batches()));
    calls.push_back(query("rsh_reduce_query", rsh_reduce_query, valid_.reduce()));
    calls.push_back({"rsh_find_features", [this] {
                         rsh_scene scene = valid_.scene.desc;
                         return rsh_find_features(&scene, valid_.host.materials.data(),
                                                  valid_.host.lights.data());
                     }});
}

void EveryCall::add_passes(std::vector<Call>& calls) const {
    calls.push_back(pass("rsh_rasterize", rsh_rasterize, valid_.rasterize()));
    for (const cl_uint mode : {RSH_BOUND_FAST, RSH_BOUND_REFIT, RSH_BOUND_QUALITY})
        calls.push_back(pass("rsh_bound", rsh_bound, bound(mode)));
    calls.push_back(pass("rsh_build", rsh_build, build(false)));
    calls.push_back(pass("rsh_build of a list", rsh_build, build(true)));
    for (const cl_uint engine : {RSH_ENGINE_TILES, RSH_ENGINE_PAPER, RSH_ENGINE_PAPER_FAITHFUL,
                                 RSH_ENGINE_BRUTE_FORCE})
        calls.push_back(pass("rsh_traverse", rsh_traverse, traverse(engine)));
    calls.push_back(pass("rsh_trace", rsh_trace, trace()));
    rsh_traverse_desc own_bounds = traverse(RSH_ENGINE_TILES);
    own_bounds.bounds = nullptr;
    calls.push_back(pass("rsh_traverse with bounds of its own", rsh_traverse, own_bounds));
    calls.push_back(pass("rsh_audit", rsh_audit, valid_.audit()));
    calls.push_back(pass("rsh_spawn", rsh_spawn, valid_.spawn()));
    calls.push_back(pass("rsh_spawn_wave", rsh_spawn_wave, valid_.spawn_wave()));
    calls.push_back(pass("rsh_gather_wave", rsh_gather_wave, valid_.gather_wave()));
    calls.push_back(pass("rsh_shadow", rsh_shadow, valid_.shadow()));
    calls.push_back(pass("rsh_find_surfaces", rsh_find_surfaces, valid_.find_surfaces()));
    calls.push_back(pass("rsh_shade", rsh_shade, valid_.shade()));
    for (cl_uint strategy = RSH_STRATEGY_CHUNK; strategy <= RSH_STRATEGY_BLELLOCH; ++strategy) {
        rsh_reduce_desc reduce = valid_.reduce();
        reduce.strategy = strategy;
        calls.push_back(pass("rsh_reduce", rsh_reduce, reduce));
    }
    rsh_reduce_desc nothing = valid_.reduce();
    nothing.count = 0;
    calls.push_back(pass("rsh_reduce of nothing", rsh_reduce, nothing));
    calls.push_back(pass("rsh_frame", rsh_frame, frame()));
    rsh_frame_desc approximate = frame();
    approximate.tolerance = 0.01f;
    calls.push_back(pass("rsh_frame, approximate", rsh_frame, approximate));
    calls.push_back(pass("rsh_trace of batches", rsh_trace, valid_.trace_batches()));
    calls.push_back(pass("rsh_frame of batches", rsh_frame, valid_.frame_batches()));
}

void EveryCall::add_blocking(std::vector<Call>& calls) const {
    const auto count = [this] { RSH_CHECK(rsh_count_statistics(rsh_.get(), CL_TRUE)); };
    const auto stop = [this] {
        finish();
        RSH_CHECK(rsh_count_statistics(rsh_.get(), CL_FALSE));
    };
    const auto traverse_counted = [=] {
        count();
        const rsh_traverse_desc desc = traverse(RSH_ENGINE_PAPER_FAITHFUL);
        RSH_CHECK(rsh_traverse(rsh_.get(), queue_(), &desc, 0, nullptr, nullptr));
    };
    const rsh_frame_desc counted_frame = frame();
    calls.push_back(
        {"rsh_frame, counted",
         [=] { return rsh_frame(rsh_.get(), queue_(), &counted_frame, 0, nullptr, &done_); },
         count, stop});
    calls.push_back({"rsh_count_statistics",
                     [this] { return rsh_count_statistics(rsh_.get(), CL_FALSE); },
                     traverse_counted, stop});
    calls.push_back({"rsh_get_statistics",
                     [this] {
                         rsh_statistics sums = {};
                         sums.struct_size = sizeof sums;
                         return rsh_get_statistics(rsh_.get(), &sums);
                     },
                     traverse_counted, stop});
    calls.push_back({"rsh_prepare", [=] {
                         const rsh_traverse_desc traverse = valid_.traverse();
                         rsh_prepare_desc desc = {};
                         desc.struct_size = sizeof desc;
                         desc.frame = &counted_frame;
                         desc.traverse = &traverse;
                         return rsh_prepare(rsh_.get(), &desc);
                     }});
    calls.push_back({"rsh_wait_prepared", [this] { return rsh_wait_prepared(rsh_.get()); }});
    calls.push_back({"rsh_device_status",
                     [this] { return rsh_device_status(rsh_.get(), queue_()); }, [] {},
                     [this] { finish(); }});
    calls.push_back({"rsh_device_selftest",
                     [this] {
                         rsh_selftest report = {};
                         report.struct_size = sizeof report;
                         return rsh_device_selftest(rsh_.get(), queue_(), &report);
                     },
                     [] {},
                     // What is found under failures is not to mask strategies from now on.
                     [this] {
                         finish();
                         rsh_selftest report = {};
                         report.struct_size = sizeof report;
                         RSH_CHECK(rsh_device_selftest(rsh_.get(), queue_(), &report));
                     }});
}

}  // namespace test
