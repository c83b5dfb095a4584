// device_results.hpp - what the device makes of operands (arithmetic/probe.cl), row by row.
#pragma once

#include <vector>

#include "arithmetic/answers.hpp"
#include "device/cl/context.hpp"

namespace rsh {

class DeviceResults {
public:
    // BLOCKS. In vectors of `lanes`: 1, or the context's width.
    DeviceResults(Context& context, cl_command_queue queue,
                  const std::vector<Operands>& operands, cl_uint lanes);

    cl_uint lanes() const { return lanes_; }
    float as_float(probe_row row, size_t index) const;
    cl_int as_int(probe_row row, size_t index) const;

private:
    cl_uint lanes_;
    size_t stride_;
    std::vector<cl_uint> words_;
};

}  // namespace rsh
