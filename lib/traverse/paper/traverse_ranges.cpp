#include "traverse/paper/traverse_ranges.hpp"

#include "bvh/layout.hpp"
#include "mesh/mesh.hpp"
#include "rays/levels.hpp"
#include "traverse/intersect.hpp"

namespace rsh {
namespace {

constexpr cl_uint kFirstNode = sizeof(nodes_head) / sizeof(cl_uint);

KernelName paper_kernel(const char* kernel) {
    return {"programs/paper", kernel};
}

KernelName hit_kernel(const rsh_traverse_desc& desc, const char* kernel) {
    return rsh::hit_kernel(desc, "programs/paper", "traverse/paper/intersect_ranges", kernel);
}

cl_mem parents_of(const RangeLevel& level, const RangeStreams& streams) {
    return streams.triangles[(level.step.level + 1) % 2];
}

// Slices to the places where their children begin, and behind them the number of all.
void scan_sums(Recorder& recorder, const range_step& step, const RangeStreams& streams) {
    const size_t group = recorder.context().caps.group_size;
    const cl_uint slices = step.parents * step.slices;
    recorder.launch(RSH_STAGE_REDUCE, paper_kernel("rsh_reduce_scan_counts"), {group, group},
                    streams.sums, slices, streams.sums, slices,
                    LocalBytes{group * sizeof(cl_uint)});
}

Range slices_range(Recorder& recorder, const range_step& step) {
    return recorder.serial_range(size_t{step.parents} * step.slices);
}

}  // namespace

void count_ranges(Recorder& recorder, const rsh_traverse_desc& desc, const RangeLevel& level,
                  const RangeStreams& streams) {
    recorder.launch(RSH_STAGE_TEST, paper_kernel("rsh_traverse_ranges_count"),
                    slices_range(recorder, level.step), level.step, bvh_whole_of(desc.geometry),
                    level.shape, desc.list_count, desc.bounds, desc.nodes, level.groups,
                    level.first_word, recorder.wrong_buffers(), parents_of(level, streams),
                    streams.ranges, streams.masks, streams.counts, streams.sums);
    scan_sums(recorder, level.step, streams);
}

void emit_ranges(Recorder& recorder, const rsh_traverse_desc& desc, const RangeLevel& level,
                 const RangeStreams& streams) {
    recorder.launch(RSH_STAGE_REDUCE, paper_kernel("rsh_traverse_ranges_emit"),
                    slices_range(recorder, level.step), level.shape, desc.list_count,
                    level.step, parents_of(level, streams), streams.masks, streams.counts,
                    streams.sums, streams.triangles[level.step.level % 2], streams.ranges,
                    streams.tally);
}

void finish_ranges(Recorder& recorder, const rsh_traverse_desc& desc, const RangeLevel& level,
                   const RangeStreams& streams) {
    const rsh_geometry& geometry = desc.geometry;
    const Answers answers = answers_of(desc);
    launch_hits(
        recorder, desc, RSH_STAGE_INTERSECT, hit_kernel(desc, "rsh_intersect_ranges_finish"),
        recorder.serial_range(node_count(level.shape, 2)), level.shape, desc.list_count,
        level.step, mesh_view_of(geometry), geometry.vertices, geometry.indices, desc.rays,
        desc.skip, desc.bounds, desc.nodes, parents_of(level, streams), streams.ranges,
        streams.sums, answers.hits, answers.occlusion, answers.occlusion_bit, streams.tally);
}

void intersect_ranges(Recorder& recorder, const rsh_traverse_desc& desc,
                      const ray_levels& shape, const RangeStreams& streams) {
    const rsh_geometry& geometry = desc.geometry;
    const Answers answers = answers_of(desc);
    launch_hits(recorder, desc, RSH_STAGE_INTERSECT, hit_kernel(desc, "rsh_intersect_ranges"),
                recorder.serial_range(node_count(shape, 2)), shape, desc.list_count,
                mesh_view_of(geometry), geometry.vertices, geometry.indices, desc.rays,
                desc.skip, desc.bounds, desc.nodes, streams.triangles[1], streams.ranges,
                answers.hits, answers.occlusion, answers.occlusion_bit);
}

void join_boxes(Recorder& recorder, const rsh_traverse_desc& desc, const ray_levels& shape,
                cl_mem upper) {
    const cl_uint first = shape.first_child_group[2];
    for (cl_uint level = 2; level < shape.count; ++level)
        recorder.launch(RSH_STAGE_BUILD, paper_kernel("rsh_join_boxes"),
                        recorder.serial_range(node_count(shape, level + 1)), shape,
                        desc.list_count, level, level == 2 ? desc.nodes : upper,
                        level == 2 ? kFirstNode : cl_uint{0},
                        level == 2 ? cl_uint{0} : shape.first_child_group[level - 1] - first,
                        upper, shape.first_child_group[level] - first);
}

}  // namespace rsh
