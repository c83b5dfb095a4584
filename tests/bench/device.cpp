// device.cpp - opening and describing the device.
#include "device.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <thread>

#include "commit.hpp"

namespace bench {

void require(rsh_status status, const char* call) {
    if (status == RSH_SUCCESS) return;
    throw std::runtime_error(
        fmt::format("{}: {}: {}", call, rsh_status_string(status), rsh_last_error()));
}

Device::Device(const std::string& name)
    : own_(name.empty() ? nullptr : name.c_str(), CL_QUEUE_PROFILING_ENABLE,
           rsh::log_from_environment()),
      device_(own_.device(), /*retainObject=*/true),
      context_(own_.context(), true),
      queue_(own_.queue(), true) {}

nlohmann::json Device::description() const {
    const cl::Platform platform(own_.platform());
    return {{"name", device_.getInfo<CL_DEVICE_NAME>()},
            {"version", device_.getInfo<CL_DEVICE_VERSION>()},
            {"driver", device_.getInfo<CL_DRIVER_VERSION>()},
            {"platform", platform.getInfo<CL_PLATFORM_NAME>()},
            {"platform_version", platform.getInfo<CL_PLATFORM_VERSION>()},
            {"compute_units", device_.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>()},
            {"memory_bytes", device_.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>()},
            {"host_threads", std::thread::hardware_concurrency()}};
}

nlohmann::json describe_library() {
    const cl_uint version = rsh_version();
    return {{"version",
             fmt::format("{}.{}.{}", version / 1000000, version / 1000 % 1000, version % 1000)},
            {"commit", kCommit}};
}

}  // namespace bench
