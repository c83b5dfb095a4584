// strategy.hpp - stream reduction: packs the kept elements of a stream. A strategy is one way
// to do it; nobody but list.cpp knows which ones there are. To add one: an enum value in rsh.h,
// a class and its kernel file, a row in list.cpp; tests and --strategy pick it up.
#pragma once

#include <vector>

#include "cl/recorder.hpp"
#include "cl/scratch.hpp"

namespace rsh {

// As rsh_reduce_desc, but the count goes to output_count[output_index].
struct ReduceStream {
    cl_uint keep;
    cl_uint element_bytes;
    cl_uint count;
    cl_mem input_count;
    cl_mem input;
    cl_mem flags;
    cl_mem output;
    cl_mem output_count;
    cl_uint output_index;
};

class Strategy {
public:
    virtual ~Strategy() = default;
    virtual cl_uint id() const noexcept = 0;        // RSH_STRATEGY_...
    virtual const char* name() const noexcept = 0;  // command lines, logs, benchmarks
    // Adds what a stream of `count` elements needs; parts are named "reduce ...".
    virtual void reserve(Layout& scratch, const Context& context, cl_uint count) const = 0;
    virtual void enqueue(Recorder& recorder, const ReduceStream& stream,
                         const Scratch& scratch) const = 0;
};

const std::vector<const Strategy*>& strategies();
const Strategy& find_strategy(cl_uint id);  // throws; RSH_STRATEGY_DEFAULT: what suits

// A strategy's kernel for the stream's elements. Pairs are reduced by the traversal's own
// program.
KernelName reduce_kernel(const ReduceStream& stream, const char* program, const char* kernel);

// rsh_reduce
Layout reduce_scratch(const Context& context, const rsh_reduce_desc& desc);
void reduce(Recorder& recorder, const rsh_reduce_desc& desc);

}  // namespace rsh
