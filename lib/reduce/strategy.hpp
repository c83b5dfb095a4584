// strategy.hpp - stream reduction: packs the kept elements of a stream. A strategy is one way
// to do it; nobody but list.cpp knows which ones there are. To add one: an enum value in rsh.h,
// a kernel file, a host file with a class like this one, a row in list.inc; tests, --strategy
// and the benchmark pick it up.
#pragma once

#include "device/choices.hpp"
#include "device/cl/recorder.hpp"
#include "device/cl/scratch.hpp"

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
    // The caller's program, if it includes the kernels of the strategies that `automatic` picks
    // from, for this stream's elements; else null.
    const char* program;
};

// What the need of scratch memory depends on.
struct ReduceShape {
    cl_uint count;
    cl_uint element_bytes;
};

class Strategy {
public:
    virtual ~Strategy() = default;
    virtual cl_uint id() const noexcept = 0;        // RSH_STRATEGY_...
    virtual const char* name() const noexcept = 0;  // command lines, logs, benchmarks
    virtual bool is_stable() const noexcept = 0;    // kept elements stay in order
    // For streams of up to `count` elements: itself, but for `auto`. unsafe: a bit per
    // strategy.
    virtual const Strategy& chosen(const Context&, cl_uint /*count*/,
                                   cl_uint /*unsafe*/) const {
        return *this;
    }
    // Adds what a stream of that shape needs; parts are named "reduce ...".
    virtual void reserve(Layout& scratch, const Context& context,
                         const ReduceShape& shape) const = 0;
    virtual void enqueue(Recorder& recorder, const ReduceStream& stream,
                         const Scratch& scratch) const = 0;
};

Choices<Strategy> strategies();
const Strategy& find_strategy(cl_uint id);  // throws
// The strategy that a call names, or `auto` for it, unless rsh_device_selftest found it wrong
// on this context's device. Asked once per call: its answer may change at any time.
cl_uint chosen_strategy(const Context& context, cl_uint id, cl_uint count);

// rsh_reduce
Layout reduce_scratch(const Context& context, const rsh_reduce_desc& desc);
void reduce(Recorder& recorder, const rsh_reduce_desc& desc);

}  // namespace rsh
