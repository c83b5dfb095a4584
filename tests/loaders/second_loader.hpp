// second_loader.hpp - a copy of an OpenCL loader beside the one that librsh is linked to, as Python's
// pyopencl brings one. The test's own objects come from it alone: what the linked loader knows by
// itself would hide what rsh must cope with.
#pragma once

#define CL_TARGET_OPENCL_VERSION 120
#define CL_USE_DEPRECATED_OPENCL_1_2_APIS
#include <CL/cl.h>
#include <CL/cl_icd.h>

#include <vector>

namespace loaders {

// The functions of the library that RSH_SECOND_LOADER of the environment names; throws when it is
// missing, or the linked one. All that it does not load are NULL.
const cl_icd_dispatch& second();

// A device of the second loader with a queue in order, which profiles.
class SecondDevice {
public:
    SecondDevice();
    ~SecondDevice();
    SecondDevice(const SecondDevice&) = delete;
    SecondDevice& operator=(const SecondDevice&) = delete;

    cl_device_id device() const { return device_; }
    cl_context context() const { return context_; }
    cl_command_queue queue() const { return queue_; }

    // Alive as long as the device.
    cl_mem buffer(size_t bytes, const void* contents = nullptr);
    template <class Value>
    cl_mem upload(const std::vector<Value>& values) {
        return buffer(values.size() * sizeof(Value), values.data());
    }
    // Blocks.
    template <class Value>
    std::vector<Value> download(cl_mem memory, size_t count) {
        std::vector<Value> values(count);
        read(memory, count * sizeof(Value), values.data());
        return values;
    }

private:
    void read(cl_mem memory, size_t bytes, void* to);

    cl_device_id device_ = nullptr;
    cl_context context_ = nullptr;
    cl_command_queue queue_ = nullptr;
    std::vector<cl_mem> buffers_;
};

// Throws, with the call's name, when a call failed.
void require(cl_int status, const char* call);

}  // namespace loaders
