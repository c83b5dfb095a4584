#include "traverse/list_hits.hpp"

#include "rays/levels.hpp"
#include "traverse/types.h"

namespace rsh {
namespace {

constexpr const char* kProgram = "traverse/list_hits";

cl_ulong tile_count(const rsh_traverse_desc& desc) {
    return node_count(box_levels(desc.width, desc.height), 2);
}

// Enough for all hits that are wanted, and for those that each tile of rays takes and does not need.
// Odd: the hits that end where records do are then at a multiple of their size.
cl_uint record_capacity(const rsh_traverse_desc& desc) {
    return static_cast<cl_uint>((desc.hit_capacity + tile_count(desc) * RSH_RECORDS_AT_ONCE) |
                                1);
}

// See kernels/traverse/hit_list.h.
size_t record_bytes(const rsh_traverse_desc& desc) {
    return (size_t{record_capacity(desc)} + 1) * sizeof(hit_record) +
           tile_count(desc) * sizeof(cl_uint);
}

// What the engine is asked for: counts, and records where hits are wanted.
rsh_traverse_desc records_of(const rsh_traverse_desc& desc, const Scratch& scratch) {
    rsh_traverse_desc pass = desc;
    pass.hit_counts = scratch["hit counts"];
    pass.hits = desc.hit_capacity > 0 ? scratch["records"] : nullptr;
    pass.hit_capacity = record_capacity(desc);
    pass.scratch = scratch["engine scratch"];
    return pass;
}

// Puts hits in their places: those that tiles have packed, in order already, then the records.
void place_hits(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem counts,
                cl_mem records) {
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    const cl_uint capacity = record_capacity(desc);
    const cl_uint packed = find_engine(desc.engine).packed_hits();
    const Range all = recorder.stream_range();
    if (packed > 0)
        recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_place_packed"},
                        recorder.serial_range(tile_count(desc)),
                        box_levels(desc.width, desc.height), desc.list_count, rays, desc.nodes,
                        counts, desc.hit_offsets, desc.hit_capacity, records, capacity,
                        desc.hits);
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_place_hits"}, all, rays, desc.hit_offsets,
                    desc.hit_capacity, records, capacity, desc.hits);
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_sort_hits"}, all, rays, desc.hit_offsets,
                    desc.hit_capacity, records, packed, desc.hits);
}

}  // namespace

Layout list_scratch(const Context& context, const rsh_traverse_desc& desc, BoundsFrom bounds) {
    Layout layout(context.caps.alignment);
    layout.add_array<cl_uint>("hit counts", ray_count(desc.width, desc.height));
    layout.add_array<cl_ulong>("sums", stream_range(context).items);
    layout.add("records", record_bytes(desc));
    layout.add("engine scratch",
               find_engine(desc.engine).scratch(context, desc, bounds).bytes());
    return layout;
}

void list_hits(Recorder& recorder, const rsh_traverse_desc& desc) {
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    const Scratch scratch(recorder, list_scratch(recorder.context(), desc, bounds_from(desc)),
                          desc.scratch);
    const rsh_traverse_desc pass = records_of(desc, scratch);
    const cl_mem counts = scratch["hit counts"], records = scratch["records"],
                 sums = scratch["sums"];
    recorder.fill(RSH_STAGE_OTHER, counts, 0, size_t{rays} * sizeof(cl_uint));
    recorder.fill(RSH_STAGE_OTHER, records, 0, sizeof(hit_records_head));
    find_engine(desc.engine).traverse(recorder, pass);
    const Range all = recorder.stream_range();
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_sum_hits"}, all, rays, counts, sums);
    recorder.launch(RSH_STAGE_REDUCE, {kProgram, "rsh_place_offsets"}, all, rays, counts, sums,
                    desc.hit_offsets);
    if (desc.hit_capacity > 0) place_hits(recorder, desc, counts, records);
}

}  // namespace rsh
