// context.hpp - what rsh_context is: programs, scratch memory and statistics for one device.
#pragma once

#include <rsh/rsh.h>

#include <atomic>

#include "device/cl/device_caps.hpp"
#include "device/cl/scratch_pool.hpp"
#include "device/cl/statistics_log.hpp"
#include "device/cl/under_way.hpp"
#include "device/log.hpp"
#include "device/objects/handle.hpp"
#include "device/programs/preparer.hpp"
#include "device/programs/programs.hpp"
#include "device/programs/variants.hpp"

namespace rsh {

class Context {
public:
    explicit Context(const rsh_context_desc& desc);

    Handle<cl_context> cl;
    cl_device_id device;  // the context keeps it
    DeviceCaps caps;
    cl_uint vector_width;
    Log log;
    Programs programs;
    Variants variants;
    ScratchPool pool;
    StatisticsLog statistics;
    UnderWay under_way;
    // Bit s: the strategy of value s gives wrong answers here; see rsh_device_selftest.
    std::atomic<cl_uint> unsafe_strategies{0};

    // The program that a call takes for `name`. Where a general one serves in its place, it is compiled
    // meanwhile.
    KernelName for_call(const KernelName& name);

    // A word on the device: what traversals met that was not made for them, RSH_WRONG_...
    cl_mem wrong_buffers() const { return wrong_buffers_.get(); }

private:
    Buffer wrong_buffers_;

public:
    Preparer preparer;  // the last one: ends before what it uses
};

// RSH_DEVICE or `name` as a substring of platform or device; see rsh_find_device.
cl_device_id find_device(const char* name);

}  // namespace rsh

struct rsh_context_s : rsh::Context {
    using rsh::Context::Context;
};
