// device.hpp - the device that is measured, opened by the library's own rules, and its description.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#include <rsh/rsh.hpp>

#include <CL/opencl.hpp>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "memory.hpp"

namespace bench {

// What an exception says, with the name of OpenCL's error.
std::string describe_error(const std::exception& error);

class Device {
public:
    // The device that rsh_find_device gives for `name`; empty: its default.
    explicit Device(const std::string& name);
    // The same, with kernels for vectors of this width.
    Device(const Device& device, cl_uint vector_width);

    const cl::Context& context() const { return context_; }
    const cl::Device& device() const { return device_; }
    const cl::CommandQueue& queue() const { return queue_; }  // in order, with profiling
    rsh_context rsh() const { return rsh_.get() ? rsh_.get() : own_->rsh(); }
    nlohmann::json description() const;
    MemoryLimits memory() const;
    bool keeps_denormals() const;  // says so itself; else they may be flushed to 0

private:
    std::shared_ptr<const rsh::Device> own_;
    rsh::Context rsh_;  // none: that of own_
    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
};

// Version and commit of the library that is measured.
nlohmann::json describe_library();

}  // namespace bench
