// device_caps.hpp - what a device can do, queried once; never guessed from a vendor's name.
#pragma once

#include <algorithm>
#include <string>

#include "device/objects/handle.hpp"

namespace rsh {

struct DeviceCaps {
    explicit DeviceCaps(cl_device_id device);

    // What kernels are compiled for where nobody asks for another: 1 where work-items are lanes.
    cl_uint default_width() const { return is_cpu ? vector_width : 1; }
    // Bytes that a call takes at most where nobody says how many.
    cl_ulong usual_budget() const { return std::min(memory / 4, max_allocation); }
    // Of every program, before its own.
    std::string build_options(cl_uint width) const;

    bool is_cpu;
    bool correctly_rounded;  // divide and square root may be asked to round correctly
    cl_uint vector_width;    // of the registers, in floats: 1, 4, 8 or 16
    cl_uint compute_units;
    size_t max_group_size;
    size_t group_size;        // of element-wise kernels
    size_t alignment;         // of sub-buffers, in bytes
    cl_ulong max_allocation;  // bytes of one buffer
    cl_ulong memory;          // bytes in all
    std::string identity;     // platform, device and driver with their versions, for cache keys
};

}  // namespace rsh
