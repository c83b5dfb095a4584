// upload.hpp - a vector as a buffer on the device.
#pragma once

#include <vector>

#include "device.hpp"

namespace bench {

template <class T>
cl::Buffer upload(const Device& device, const std::vector<T>& items) {
    if (items.empty()) return cl::Buffer();
    const size_t bytes = items.size() * sizeof(T);
    cl::Buffer buffer(device.context(), CL_MEM_READ_WRITE, bytes);
    device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, items.data());
    return buffer;
}

}  // namespace bench
