// block.cpp - the paper's reduction (reduce/block.cl): blocks on their own, a scan of their
// counts, then each block's range moved to its place. Two strategies that differ in the first
// step: `block` scatters within a block, `block_search` searches as the paper had to.
#include <algorithm>

#include "reduce/launch.hpp"

namespace rsh {
namespace {

// Of a single item: its ranges stay in the cache from the first step to the third.
constexpr cl_uint kItemBlock = 4096;

class Block : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_BLOCK; }
    const char* name() const noexcept override { return "block"; }
    bool is_stable() const noexcept override { return true; }

    void reserve(Layout& scratch, const Context& context,
                 const ReduceShape& shape) const override {
        scratch.add("reduced blocks", size_t{shape.count} * shape.element_bytes);
        scratch.add_array<cl_uint>("reduce counts", block_count(context, shape.count));
    }

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override {
        const cl_uint blocks = block_count(recorder.context(), stream.count);
        const cl_mem reduced = scratch["reduced blocks"], counts = scratch["reduce counts"];
        reduce_blocks(recorder, stream, reduced, counts);
        scan_counts(recorder, stream, counts, blocks);
        launch(recorder, stream, kernel_for(stream, "reduce/block", "rsh_reduce_block_move"),
               recorder.stream_range(), block_size(recorder.context()), blocks, reduced, counts,
               stream.output_count, stream.output_index, stream.output);
    }

protected:
    virtual cl_uint block_size(const Context& context) const {
        return has_single_items(context) ? kItemBlock : group_tile(context);
    }
    virtual void reduce_blocks(Recorder& recorder, const ReduceStream& stream, cl_mem reduced,
                               cl_mem counts) const {
        if (!has_single_items(recorder.context())) {
            reduce_in_groups(recorder, stream, "rsh_reduce_block_scatter", reduced, counts);
            return;
        }
        launch(recorder, stream, kernel_for(stream, "reduce/block", "rsh_reduce_block_items"),
               recorder.stream_range(), kItemBlock,
               block_count(recorder.context(), stream.count), reduced, counts);
    }

    cl_uint block_count(const Context& context, cl_uint count) const {
        return std::max(1u, divided_up(count, block_size(context)));
    }
    // A group per block.
    void reduce_in_groups(Recorder& recorder, const ReduceStream& stream, const char* kernel,
                          cl_mem reduced, cl_mem counts) const {
        const Context& context = recorder.context();
        launch(recorder, stream, kernel_for(stream, "reduce/block", kernel),
               groups(context, block_count(context, stream.count)), reduced, counts,
               group_words(context));
    }
};

class BlockSearch final : public Block {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_BLOCK_SEARCH; }
    const char* name() const noexcept override { return "block_search"; }

protected:
    cl_uint block_size(const Context& context) const override { return group_items(context); }
    void reduce_blocks(Recorder& recorder, const ReduceStream& stream, cl_mem reduced,
                       cl_mem counts) const override {
        reduce_in_groups(recorder, stream, "rsh_reduce_block_search", reduced, counts);
    }
};

}  // namespace

const Strategy& block() {
    static const Block strategy;
    return strategy;
}

const Strategy& block_search() {
    static const BlockSearch strategy;
    return strategy;
}

}  // namespace rsh
