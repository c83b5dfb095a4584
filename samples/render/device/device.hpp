// device.hpp - rsh::Device in the words of the C++ bindings, and the one place where statuses
// become exceptions. Owns no scene.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#include <rsh/rsh.hpp>

#include <CL/opencl.hpp>
#include <string>

namespace render {

// Throws std::runtime_error with the call's name and rsh_last_error() unless it succeeded.
void require(rsh_status status, const char* call);

class Device {
public:
    // The device that rsh_find_device gives for `name`; empty: its default.
    explicit Device(const std::string& name);

    const cl::Context& context() const { return context_; }
    const cl::CommandQueue& queue() const { return queue_; }  // in order, with profiling
    rsh_context rsh() const { return own_.rsh(); }
    std::string name() const;
    std::string platform() const;

    cl::Buffer buffer(size_t bytes) const;

private:
    rsh::Device own_;
    cl::Context context_;
    cl::CommandQueue queue_;
};

// One line per device: platform, name, OpenCL version, compute units, memory.
std::string list_devices();

}  // namespace render
