// device.cpp - opening and describing the device.
#include "device.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <thread>

#include "commit.hpp"
#include "host.hpp"

namespace bench {

std::string describe_error(const std::exception& error) {
    const auto* cl_error = dynamic_cast<const cl::Error*>(&error);
    if (!cl_error) return error.what();
    return fmt::format("{}: OpenCL error {} ({})", error.what(), cl_error->err(),
                       rsh_status_string(cl_error->err()));
}

Device::Device(const std::string& name)
    : own_(std::make_shared<rsh::Device>(name.empty() ? nullptr : name.c_str(),
                                         CL_QUEUE_PROFILING_ENABLE,
                                         rsh::log_from_environment())),
      rsh_(static_cast<rsh_context>(nullptr)),
      device_(own_->device(), /*retainObject=*/true),
      context_(own_->context(), true),
      queue_(own_->queue(), true) {}

Device::Device(const Device& device, cl_uint vector_width)
    : own_(device.own_),
      rsh_(static_cast<rsh_context>(nullptr)),
      device_(device.device_),
      context_(device.context_),
      queue_(device.queue_) {
    rsh_context_desc desc = rsh::make<rsh_context_desc>();
    desc.context = context_();
    desc.device = device_();
    desc.vector_width = vector_width;
    desc.log = rsh::log_from_environment();
    rsh_ = rsh::Context(desc);
}

nlohmann::json Device::description() const {
    const cl::Platform platform(own_->platform());
    return {{"name", device_.getInfo<CL_DEVICE_NAME>()},
            {"version", device_.getInfo<CL_DEVICE_VERSION>()},
            {"driver", device_.getInfo<CL_DRIVER_VERSION>()},
            {"platform", platform.getInfo<CL_PLATFORM_NAME>()},
            {"platform_version", platform.getInfo<CL_PLATFORM_VERSION>()},
            {"compute_units", device_.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>()},
            {"memory_bytes", memory().device_bytes},
            {"largest_allocation_bytes", memory().largest_bytes},
            {"native_vector_width", device_.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>()},
            {"host_threads", std::thread::hardware_concurrency()},
            {"host_instruction_set", host_instruction_set()}};
}

MemoryLimits Device::memory() const {
    MemoryLimits limits;
    limits.device_bytes = device_.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    limits.largest_bytes = device_.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    limits.host_bytes = size_t(sysconf(_SC_PHYS_PAGES)) * size_t(sysconf(_SC_PAGESIZE));
    limits.is_shared = device_.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>();
    return limits;
}

bool Device::keeps_denormals() const {
    return (device_.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_DENORM) != 0;
}

nlohmann::json describe_library() {
    const cl_uint version = rsh_version();
    return {{"version",
             fmt::format("{}.{}.{}", version / 1000000, version / 1000 % 1000, version % 1000)},
            {"commit", kCommit}};
}

}  // namespace bench
