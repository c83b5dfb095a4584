// device.hpp - opening and naming OpenCL devices. Owns none.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#include <rsh/rsh.hpp>

#include <CL/opencl.hpp>
#include <string>

namespace render {

// The device that rsh_find_device gives for `name`; empty: its default. Its queue is in order and
// profiles.
rsh::Device open_device(const std::string& name);
std::string name_of(const rsh::Device& device);
std::string platform_of(const rsh::Device& device);

// One line per device: platform, name, OpenCL version, compute units, memory.
std::string list_devices();

}  // namespace render
