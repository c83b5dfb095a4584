#include "memory.hpp"

#include <fmt/format.h>

namespace bench {

std::string memory_refusal(const MemoryLimits& limits, const std::vector<NamedBytes>& buffers,
                           size_t host_bytes) {
    size_t device_bytes = 0;
    for (const NamedBytes& buffer : buffers) {
        if (buffer.bytes > limits.largest_bytes)
            return fmt::format("{} needs {} bytes in one buffer, the device allows {}",
                               buffer.name, buffer.bytes, limits.largest_bytes);
        device_bytes += buffer.bytes;
    }
    if (device_bytes > limits.device_bytes)
        return fmt::format("needs {} bytes of device memory, the device has {}", device_bytes,
                           limits.device_bytes);
    if (limits.is_shared) host_bytes += device_bytes;
    if (host_bytes > limits.host_bytes)
        return fmt::format("needs {} bytes of host memory, the machine has {}", host_bytes,
                           limits.host_bytes);
    return {};
}

}  // namespace bench
