// ptxas_log.hpp - what NVIDIA's assembler says of each kernel in a build log when it is asked to be
// verbose (-cl-nv-verbose, of the extension cl_nv_compiler_options). Asks no device.
#pragma once

#include <map>
#include <string>

namespace bench {

struct PtxasFigures {
    unsigned registers = 0;    // of a work-item
    unsigned stack_bytes = 0;  // with what the kernel calls
    unsigned spill_store_bytes = 0, spill_load_bytes = 0;
    unsigned shared_bytes = 0;  // of a work-group
};

// By the kernel's name; empty when the log has nothing of that kind.
std::map<std::string, PtxasFigures> read_ptxas_log(const std::string& log);

}  // namespace bench
