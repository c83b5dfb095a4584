// ray_features.cpp - features of rsh_trace. The absent ones of a row find one and the same hits.
#include "ablation/features.hpp"
#include "ablation/trace_work.hpp"

namespace bench::ablation {
namespace {

using Change = std::function<void(TraceSetup&, const Stage&)>;

constexpr const char* kAlwaysThere = "every program has it, and is told at run time";
constexpr const char* kOwnProgram =
    "a program of its own, which is launched when it is asked for";

std::function<std::unique_ptr<Work>(const Stage&)> trace_of(Change change) {
    return [=](const Stage& stage) {
        TraceSetup setup;
        change(setup, stage);
        return std::make_unique<TraceWork>(stage.device, stage.layers, setup, stage.most_hits);
    };
}

void nothing(TraceSetup&, const Stage&) {}

// It cannot be left out of the program.
Feature always_there(const char* name, const Change& used, const Change& absent = nothing) {
    return {name,
            {{kLeftOut, {}, kAlwaysThere},
             {kCompiledIn, trace_of(absent), ""},
             {kUsed, trace_of(used), ""}},
            false};
}

// No program that does without has it.
Feature own_program(const char* name, const Change& used) {
    return {name,
            {{kLeftOut, trace_of(nothing), ""},
             {kCompiledIn, {}, kOwnProgram},
             {kUsed, trace_of(used), ""}},
            false};
}

Change query(cl_uint query) {
    return [=](TraceSetup& setup, const Stage&) { setup.query = query; };
}

size_t rays_of(const Stage& stage) {
    return stage.layers.rays.rays.size();
}

// Four meshes, one for each bit of four.
void add_ranges(TraceSetup& setup, const Stage& stage) {
    const cl_uint triangles = stage.layers.mesh.triangle_count();
    for (cl_uint k = 0; k < 4; ++k)
        setup.ranges.push_back({k * (triangles / 4), 10 + k, 1u << k, 0});
}

// Seen from inside, only backs are hit.
void cull_fronts(TraceSetup& setup, const Stage&) {
    setup.cull = RSH_CULL_FRONT;
}

void add_full_masks(TraceSetup& setup, const Stage& stage) {
    setup.masks.assign(rays_of(stage), 0xffffffffu);
}

// Two meshes of four for each ray.
void add_masks(TraceSetup& setup, const Stage& stage) {
    add_ranges(setup, stage);
    for (cl_uint i = 0; i < rays_of(stage); ++i) setup.masks.push_back(i & 1 ? 0x5 : 0xa);
}

// Culling and masks are compiled into the same programs: of each, the other one is "compiled in".
Feature filter(const char* name, const Change& compiled_in, const Change& used) {
    return {name,
            {{kLeftOut, trace_of(nothing), ""},
             {kCompiledIn, trace_of(compiled_in), ""},
             {kUsed, trace_of(used), ""}},
            false};
}

void add_skip(TraceSetup& setup, const Stage& stage) {
    const cl_uint triangles = stage.layers.mesh.triangle_count();
    for (cl_uint i = 0; i < rays_of(stage); ++i) setup.skip.push_back(i * 7919u % triangles);
}

void make_soup(TraceSetup& setup, const Stage&) {
    setup.is_soup = true;
}

void make_list(TraceSetup& setup, const Stage&) {
    setup.is_list = true;
}

}  // namespace

std::vector<Feature> ray_features() {
    return {
        always_there("any_hit", query(RSH_QUERY_ANY)),
        own_program("count", query(RSH_QUERY_COUNT)),
        own_program("all_hits", query(RSH_QUERY_ALL)),
        always_there("indices", nothing, make_soup),
        filter("ray_masks", cull_fronts, add_masks),
        filter("cull", add_full_masks, cull_fronts),
        always_there("skip", add_skip),
        always_there(
            "list_count",
            [](TraceSetup& setup, const Stage&) {
                setup.is_list = setup.has_list_count = true;
            },
            make_list),
        own_program("normals",
                    [](TraceSetup& setup, const Stage&) { setup.has_normals = true; }),
        own_program("geometry_ids",
                    [](TraceSetup& setup, const Stage& stage) {
                        add_ranges(setup, stage);
                        setup.has_ids = true;
                    }),
        own_program("packed_rays",
                    [](TraceSetup& setup, const Stage&) { setup.is_packed = true; }),
    };
}

}  // namespace bench::ablation
