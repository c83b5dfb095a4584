// device.cpp - opening and describing the device.
#include "device.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "commit.hpp"

namespace bench {

void require(rsh_status status, const char* call) {
    if (status == RSH_SUCCESS) return;
    throw std::runtime_error(
        fmt::format("{}: {}: {}", call, rsh_status_string(status), rsh_last_error()));
}

namespace {

// What the library says of programs and strategies.
void log_line(const char* message, void*) {
    fmt::print(stderr, "rsh: {}\n", message);
}

bool wants_log() {
    const char* wanted = std::getenv("RSH_LOG");
    return wanted && std::string_view(wanted) == "1";
}

}  // namespace

Device::Device(const std::string& name) {
    cl_device_id device = nullptr;
    require(rsh_find_device(name.empty() ? nullptr : name.c_str(), nullptr, &device),
            "rsh_find_device");
    device_ = cl::Device(device, /*retainObject=*/true);
    context_ = cl::Context(device_);
    queue_ = cl::CommandQueue(context_, device_, CL_QUEUE_PROFILING_ENABLE);
    rsh_context_desc desc{};
    desc.struct_size = sizeof desc;
    desc.context = context_();
    desc.device = device;
    if (wants_log()) desc.log = log_line;
    rsh_context context = nullptr;
    require(rsh_create_context(&desc, &context), "rsh_create_context");
    rsh_.reset(context);
}

nlohmann::json Device::description() const {
    const cl::Platform platform(device_.getInfo<CL_DEVICE_PLATFORM>());
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
