// paper_faithful.cpp - the traversal of Roger, Assarsson and Holzschuch 2007: breadth first,
// one level per pass, every triangle against the root, four children per pair, a reduction
// after each level.
#include <algorithm>
#include "traverse/engine.hpp"

#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "traverse/intersect.hpp"
#include "traverse/paper_faithful/traverse_level.hpp"
#include "traverse/paper_faithful/types.h"

namespace rsh {
namespace {

constexpr size_t kDefaultBudget = 64u << 20;
// A pair that is tested takes four tested pairs and, if all survive, four places behind them.
constexpr size_t kBytesPerTest = 8 * sizeof(stream_pair);
// Its four tested pairs are counted in 32 bits.
constexpr cl_ulong kMaxLimit = (1u << 29) - 1;

ray_levels cone_levels(const rsh_traverse_desc& desc) {
    return find_shape(RSH_SHAPE_CONE).levels(desc.width, desc.height);
}

// Pairs that a level can test. Never more than the scene can make: one per triangle and node of
// level 1, the finest that is tested.
cl_uint limit_of(const rsh_traverse_desc& desc, const ray_levels& levels) {
    const size_t budget = desc.budget ? desc.budget : kDefaultBudget;
    const cl_ulong finest = cl_ulong{levels.width[1]} * levels.height[1];
    const cl_ulong possible = std::max<cl_ulong>(1, desc.geometry.triangle_count * finest);
    return static_cast<cl_uint>(
        std::min({cl_ulong{budget / kBytesPerTest}, possible, kMaxLimit}));
}

// The stream at a level holds at most a batch times the level's nodes.
bool can_overflow(const ray_levels& levels, cl_uint level, cl_uint triangles, cl_uint limit) {
    const cl_ulong nodes = cl_ulong{levels.width[level]} * levels.height[level];
    return triangles * nodes > limit;
}

// A batch starts as a quarter of what a level can test: streams grow on their way down, and
// what outgrows the limit is walked depth first.
cl_uint batch_triangles(const rsh_traverse_desc& desc, const ray_levels& levels,
                        cl_uint limit) {
    const cl_uint all = desc.geometry.triangle_count;
    if (!can_overflow(levels, 1, all, limit)) return all;
    return std::max<cl_uint>(1, std::min(all, limit / 4));
}

ReduceStream survivors(const PairStreams& streams, cl_uint level) {
    ReduceStream stream = {};
    stream.keep = RSH_KEEP_NOT_NULL;
    stream.element_bytes = sizeof(stream_pair);
    stream.count = 4 * streams.limit;
    stream.input_count = streams.tested_count;
    stream.input = streams.tested_pairs;
    stream.output = streams.pairs;
    stream.output_count = streams.counts;
    stream.output_index = level;
    stream.program = "programs/paper_faithful";
    return stream;
}

// counts[l] is the length of the stream at level l. The highest one that is not empty is that of the
// root: its pairs are not stored.
void add_counts(rsh_statistics& sums, cl_uint levels, cl_uint limit, const cl_uint* counts) {
    cl_uint root = levels;
    while (root > 0 && counts[root] == 0) --root;
    ++sums.batches;
    sums.pairs_tested[root] += counts[root];
    sums.node_tests += counts[root];
    sums.ray_tests += counts[0];
    for (cl_uint l = 0; l < root; ++l) {
        const cl_ulong pairs = counts[l];
        const cl_ulong walked = l > 0 && pairs > limit ? pairs - limit : 0;
        sums.pairs_tested[l] += pairs;
        sums.pairs_walked[l] += walked;
        if (l > 0) sums.node_tests += 4 * pairs;
        sums.peak_pairs = std::max(sums.peak_pairs, pairs);
    }
}

void count_statistics(Recorder& recorder, const ray_levels& levels,
                      const PairStreams& streams) {
    if (!recorder.context().statistics.enabled()) return;
    const cl_uint limit = streams.limit, count = levels.count;
    recorder.count_later(streams.counts, count + 1,
                         [limit, count](rsh_statistics& sums, const cl_uint* counts) {
                             add_counts(sums, count, limit, counts);
                         });
}

class Traversal {
public:
    Traversal(Recorder& recorder, const rsh_traverse_desc& desc, const Layout& layout)
        : recorder_(recorder),
          desc_(desc),
          levels_(cone_levels(desc)),
          strategy_(find_strategy(desc.strategy)),
          scratch_(recorder, layout, desc.scratch),
          streams_{limit_of(desc, levels_), scratch_["pairs"], scratch_["tested_pairs"],
                   scratch_["tested count"], scratch_["counts"]} {
        if (!desc_.bounds) desc_.bounds = make_bounds(recorder_, desc_, scratch_);
    }

    void run() {
        clear_hits(recorder_, desc_, "programs/paper_faithful");
        const cl_uint total = desc_.geometry.triangle_count;
        const cl_uint size = batch_triangles(desc_, levels_, streams_.limit);
        for (cl_uint first = 0; first < total; first += size) {
            report_progress(desc_, first / size, (total + size - 1) / size);
            run_batch({first, std::min(size, total - first)});
        }
        resolve(recorder_, desc_);
    }

private:
    void run_batch(const Batch& batch) {
        for (cl_uint level = levels_.count; level-- > 0;) {
            test_level(recorder_, desc_, levels_, level, streams_, batch);
            const bool is_stored = level + 1 < levels_.count;
            if (is_stored &&
                can_overflow(levels_, level + 1, batch.triangle_count, streams_.limit))
                walk_level(recorder_, desc_, levels_, level, streams_);
            pack_survivors(level);
        }
        intersect(recorder_, desc_, streams_.pairs, streams_.counts);
        count_statistics(recorder_, levels_, streams_);
    }

    void pack_survivors(cl_uint level) {
        strategy_.enqueue(recorder_, survivors(streams_, level), scratch_);
    }

    Recorder& recorder_;
    rsh_traverse_desc desc_;
    ray_levels levels_;
    const Strategy& strategy_;
    Scratch scratch_;
    PairStreams streams_;
};

class PaperFaithful final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_PAPER_FAITHFUL; }
    const char* name() const noexcept override { return "paper_faithful"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_CONE; }

    cl_uint longest_stream(const rsh_traverse_desc& desc) const override {
        return 4 * limit_of(desc, cone_levels(desc));
    }

    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   BoundsFrom from) const override {
        const ray_levels levels = cone_levels(desc);
        const cl_uint limit = limit_of(desc, levels);
        Layout layout(context.caps.alignment);
        layout.add_array<stream_pair>("pairs", size_t{4} * limit);
        layout.add_array<stream_pair>("tested_pairs", size_t{4} * limit);
        layout.add_array<cl_uint>("tested count", 1);
        layout.add_array<cl_uint>("counts", RSH_MAX_LEVELS + 1);
        reserve_bounds(layout, context, desc, from);
        find_strategy(desc.strategy).reserve(layout, context, {4 * limit, sizeof(stream_pair)});
        return layout;
    }

    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override {
        if (desc.width == 0) return;
        Traversal(recorder, desc, scratch(recorder.context(), desc, bounds_from(desc))).run();
    }
};

}  // namespace

const Engine& paper_faithful_engine() {
    static const PaperFaithful engine;
    return engine;
}

}  // namespace rsh
