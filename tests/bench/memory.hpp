// memory.hpp - whether what a case needs fits, asked before anything is allocated.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

struct MemoryLimits {
    size_t device_bytes = 0;   // CL_DEVICE_GLOBAL_MEM_SIZE
    size_t largest_bytes = 0;  // CL_DEVICE_MAX_MEM_ALLOC_SIZE
    size_t host_bytes = 0;     // of the machine
    bool is_shared = false;    // the device's memory is the host's
};

struct NamedBytes {
    std::string name;
    size_t bytes;
};

// Why a case cannot be: "the output needs 4294967296 bytes in one buffer, the device allows
// 1073741824". Empty: it can.
std::string memory_refusal(const MemoryLimits& limits, const std::vector<NamedBytes>& buffers,
                           size_t host_bytes);

}  // namespace bench
