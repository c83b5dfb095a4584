// paper.cpp - the traversal of Roger, Assarsson and Holzschuch 2007, tuned: breadth first,
// every triangle against the root, and no early end, but 16 children per node tested at a time,
// a range of triangles per node instead of a stream of pairs, and survivors counted before they
// are written. What paper_faithful.cpp does as written, for comparison.
#include <algorithm>
#include "traverse/engine.hpp"

#include "bvh/layout.hpp"
#include "rays/levels.hpp"
#include "rays/types.h"
#include "traverse/intersect.hpp"
#include "traverse/paper/traverse_ranges.hpp"

namespace rsh {
namespace {

// Of the streams of two levels, and the mask of the parents'.
constexpr size_t kBytesPerTriangle = 2 * sizeof(cl_uint) + sizeof(cl_ushort);
// Survivors of a level, 16 for each, are counted in 32 bits.
constexpr cl_ulong kMaxCapacity = 1u << 27;
constexpr size_t kDefaultBytes = 40;  // per ray and per triangle

cl_uint nodes_of(const ray_levels& levels, cl_uint level) {
    return static_cast<cl_uint>(node_count(levels, level));
}

cl_uint slices_of(const Context& context, const ray_levels& levels, cl_uint level) {
    const cl_uint wanted = context.vector_width > 1 ? 32 * context.caps.compute_units : 4096;
    const cl_uint parents = std::max(nodes_of(levels, level + 1), 1u);
    return std::clamp(wanted / parents, 1u, cl_uint{RSH_MAX_SLICES});
}

// What ranges name: places in the leaves, some of them empty.
cl_uint names_of(const rsh_traverse_desc& desc) {
    return 16 * bvh_whole_of(desc.geometry).leaves;
}

// Triangles that a level can hold; never more than the scene can make.
cl_uint capacity_of(const rsh_traverse_desc& desc, const ray_levels& levels) {
    const cl_ulong triangles = names_of(desc);
    const cl_ulong usual =
        kDefaultBytes * (ray_count(desc.width, desc.height) + triangles) + RSH_MIN_BUDGET;
    const cl_ulong budget = desc.budget ? desc.budget : usual;
    const cl_ulong possible = std::max<cl_ulong>(1, triangles * node_count(levels, 1));
    return static_cast<cl_uint>(std::min({budget / kBytesPerTriangle, possible, kMaxCapacity}));
}

bool can_overflow(const ray_levels& levels, cl_uint level, cl_uint triangles,
                  cl_uint capacity) {
    return triangles * node_count(levels, level) > capacity;
}

// A batch starts as a quarter of what a level can hold: streams grow on their way down, and
// what outgrows them is finished otherwise.
cl_uint batch_triangles(const rsh_traverse_desc& desc, const ray_levels& levels,
                        cl_uint capacity) {
    const cl_uint all = names_of(desc);
    if (!can_overflow(levels, 1, all, capacity)) return all;
    return std::max<cl_uint>(1, std::min(all, capacity / 4));
}

// The ranges of level 1 stand first.
cl_uint first_range(const ray_levels& levels, cl_uint level) {
    cl_uint first = 0;
    for (cl_uint l = 1; l < level; ++l) first += nodes_of(levels, l);
    return first;
}

void add_tally(rsh_statistics& sums, cl_uint batch_count, const cl_uint* tally) {
    ++sums.batches;
    const cl_uint root = tally[RSH_TALLY_ROOT];
    if (root == 0) return;
    sums.pairs_tested[root] += batch_count;
    sums.node_tests += 16 * cl_ulong{batch_count};
    for (cl_uint level = root - 1; level > 0; --level) {
        const cl_ulong held = tally[level];
        sums.pairs_tested[level] += tally[RSH_TALLY_SURVIVORS + level];
        sums.pairs_walked[level] += tally[RSH_TALLY_SURVIVORS + level] - held;
        sums.peak_pairs = std::max(sums.peak_pairs, held);
        (level > 1 ? sums.node_tests : sums.ray_tests) += 16 * held;
    }
    const cl_ulong by_blocks = count_of(tally + RSH_TALLY_FINISHED);
    const cl_ulong by_rays = count_of(tally + RSH_TALLY_FINISHED + 2);
    sums.node_tests += 16 * by_blocks;
    sums.ray_tests += 16 * by_rays;
    sums.pairs_tested[0] += 16 * (tally[1] + by_rays);
}

class Traversal {
public:
    Traversal(Recorder& recorder, const rsh_traverse_desc& desc, const Layout& layout)
        : recorder_(recorder),
          desc_(desc),
          shape_(group_levels(desc.width, desc.height)),
          scratch_(recorder, layout, desc.scratch),
          streams_{capacity_of(desc, shape_), {scratch_["even levels"], scratch_["odd levels"]},
                   scratch_["ranges"],        scratch_["masks"],
                   scratch_["counts"],        scratch_["sums"],
                   scratch_["tally"]} {
        if (!desc_.bounds) desc_.bounds = make_bounds(recorder_, desc_, scratch_);
    }

    void run() {
        if (!desc_.continued) clear_hits(recorder_, desc_, "programs/paper");
        join_boxes(recorder_, desc_, shape_, scratch_["nodes"]);
        const cl_uint total = names_of(desc_);
        const cl_uint size = batch_triangles(desc_, shape_, streams_.capacity);
        for (cl_uint first = 0; first < total; first += size) {
            report_progress(desc_, first / size, (total + size - 1) / size);
            trace_batch(first, std::min(size, total - first));
        }
    }

private:
    void trace_batch(cl_uint first, cl_uint count) {
        const bool is_counting = recorder_.context().statistics.enabled();
        if (is_counting)
            recorder_.fill(RSH_STAGE_OTHER, streams_.tally, 0,
                           RSH_TALLY_WORDS * sizeof(cl_uint));
        for (cl_uint level = shape_.count; level-- > 1;) {
            const RangeLevel step = level_of(level, first, count);
            count_ranges(recorder_, desc_, step, streams_);
            emit_ranges(recorder_, desc_, step, streams_);
            if (can_overflow(shape_, level, count, streams_.capacity))
                finish_ranges(recorder_, desc_, step, streams_);
        }
        intersect_ranges(recorder_, desc_, shape_, streams_);
        if (!is_counting) return;
        recorder_.count_later(streams_.tally, RSH_TALLY_WORDS,
                              [count](rsh_statistics& sums, const cl_uint* tally) {
                                  add_tally(sums, count, tally);
                              });
    }

    RangeLevel level_of(cl_uint level, cl_uint first, cl_uint count) {
        const bool is_upper = level > 1;
        range_step step = {};
        step.level = level;
        step.parents = nodes_of(shape_, level + 1);
        step.slices = slices_of(recorder_.context(), shape_, level);
        step.first_child_group =
            shape_.first_child_group[level] - (is_upper ? shape_.first_child_group[2] : 0);
        step.first_parent_range = first_range(shape_, level + 1);
        step.first_child_range = first_range(shape_, level);
        step.capacity = streams_.capacity;
        step.is_root = level + 1 == shape_.count;
        step.batch_first = first;
        step.batch_count = count;
        step.is_counting = recorder_.context().statistics.enabled();
        const cl_uint first_word = is_upper ? 0 : sizeof(nodes_head) / sizeof(cl_uint);
        return {shape_, step, is_upper ? scratch_["nodes"] : desc_.nodes, first_word};
    }

    Recorder& recorder_;
    rsh_traverse_desc desc_;
    ray_levels shape_;
    Scratch scratch_;
    RangeStreams streams_;
};

class Paper final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_PAPER; }
    const char* name() const noexcept override { return "paper"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_BOX; }
    // A work-item holds 16 nodes, or the rays of a block: kilobytes of private memory.
    bool suits(const DeviceCaps& caps) const noexcept override { return caps.is_cpu; }
    bool continues_hits() const noexcept override { return true; }

    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   BoundsFrom from) const override {
        const ray_levels shape = group_levels(desc.width, desc.height);
        const cl_uint capacity = capacity_of(desc, shape);
        size_t slices = 0;
        for (cl_uint level = 1; level < shape.count; ++level)
            slices = std::max(
                slices, size_t{nodes_of(shape, level + 1)} * slices_of(context, shape, level));
        Layout layout(context.caps.alignment);
        layout.add_array<cl_uint>("even levels", capacity);
        layout.add_array<cl_uint>("odd levels", capacity);
        layout.add_array<cl_ushort>("masks", capacity);
        layout.add_array<cl_uint2>("ranges", first_range(shape, shape.count));
        layout.add_array<cl_uint16>("counts", slices);
        layout.add_array<cl_uint>("sums", slices + 1);
        layout.add_array<cl_uint>("tally", RSH_TALLY_WORDS);
        layout.add_array<box_node16>(
            "nodes", shape.first_child_group[shape.count] - shape.first_child_group[2]);
        reserve_bounds(layout, context, desc, from);
        return layout;
    }

    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override {
        if (desc.width == 0) return;
        Traversal(recorder, desc, scratch(recorder.context(), desc, bounds_from(desc))).run();
    }
};

}  // namespace

const Engine& paper_engine() {
    static const Paper engine;
    return engine;
}

}  // namespace rsh
