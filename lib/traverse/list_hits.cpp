#include "traverse/list_hits.hpp"

#include "rays/levels.hpp"
#include "traverse/types.h"

namespace rsh {
namespace {

constexpr const char* kProgram = "traverse/list_hits";

// Enough for all hits that are wanted, and for those that each tile of rays takes and does not need.
cl_uint record_capacity(const rsh_traverse_desc& desc) {
    const cl_ulong tiles = node_count(box_levels(desc.width, desc.height), 2);
    return static_cast<cl_uint>(desc.hit_capacity + tiles * RSH_RECORDS_AT_ONCE);
}

// What the engine is asked for: counts and records.
rsh_traverse_desc records_of(const rsh_traverse_desc& desc, const Scratch& scratch) {
    rsh_traverse_desc pass = desc;
    pass.hit_counts = scratch["hit counts"];
    pass.hits = scratch["records"];
    pass.hit_capacity = record_capacity(desc);
    pass.scratch = scratch["engine scratch"];
    return pass;
}

}  // namespace

Layout list_scratch(const Context& context, const rsh_traverse_desc& desc, BoundsFrom bounds) {
    Layout layout(context.caps.alignment);
    layout.add_array<cl_uint>("hit counts", ray_count(desc.width, desc.height));
    layout.add_array<cl_ulong>("sums", stream_range(context).items);
    layout.add_array<hit_record>("records", size_t{record_capacity(desc)} + 1);
    layout.add("engine scratch",
               find_engine(desc.engine).scratch(context, desc, bounds).bytes());
    return layout;
}

void list_hits(Recorder& recorder, const rsh_traverse_desc& desc) {
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    const Scratch scratch(recorder, list_scratch(recorder.context(), desc, bounds_from(desc)),
                          desc.scratch);
    const rsh_traverse_desc pass = records_of(desc, scratch);
    const cl_mem counts = pass.hit_counts, records = pass.hits, sums = scratch["sums"];
    const auto capacity = static_cast<cl_uint>(pass.hit_capacity);
    recorder.fill(RSH_STAGE_OTHER, counts, 0, size_t{rays} * sizeof(cl_uint));
    recorder.fill(RSH_STAGE_OTHER, records, 0, sizeof(hit_records_head));
    find_engine(desc.engine).traverse(recorder, pass);
    const Range all = recorder.stream_range();
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_sum_hits"}, all, rays, counts, sums);
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_place_offsets"}, all, rays, counts, sums,
                    desc.hit_offsets);
    if (desc.hit_capacity == 0) return;
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_place_hits"}, all, rays, desc.hit_offsets,
                    desc.hit_capacity, records, capacity, desc.hits);
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_sort_hits"}, all, rays, desc.hit_offsets,
                    desc.hit_capacity, desc.hits);
}

}  // namespace rsh
