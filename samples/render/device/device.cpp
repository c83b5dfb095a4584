// device.cpp - opening and listing of OpenCL devices.
#include "device/device.hpp"

#include <fmt/format.h>

#include <vector>

namespace render {

rsh::Device open_device(const std::string& name) {
    return rsh::Device(name.empty() ? nullptr : name.c_str(), CL_QUEUE_PROFILING_ENABLE,
                       rsh::log_from_environment());
}

std::string name_of(const rsh::Device& device) {
    return cl::Device(device.device(), true).getInfo<CL_DEVICE_NAME>();
}

std::string platform_of(const rsh::Device& device) {
    return cl::Platform(device.platform()).getInfo<CL_PLATFORM_NAME>();
}

namespace {

std::string describe(const cl::Platform& platform, const cl::Device& device) {
    return fmt::format("{}: {} ({}, {} compute units, {} MiB)\n",
                       platform.getInfo<CL_PLATFORM_NAME>(), device.getInfo<CL_DEVICE_NAME>(),
                       device.getInfo<CL_DEVICE_VERSION>(),
                       device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>(),
                       device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>() >> 20);
}

// Platforms without a device answer CL_DEVICE_NOT_FOUND.
std::vector<cl::Device> devices_of(const cl::Platform& platform) {
    std::vector<cl::Device> devices;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error& error) {
        if (error.err() != CL_DEVICE_NOT_FOUND) throw;
    }
    return devices;
}

}  // namespace

std::string list_devices() {
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        // The loader reports an error when no driver is installed.
    }
    std::string lines;
    for (const cl::Platform& platform : platforms)
        for (const cl::Device& device : devices_of(platform))
            lines += describe(platform, device);
    cl_device_id none = nullptr;
    if (lines.empty()) rsh::check(rsh_find_device("", nullptr, &none), "rsh_find_device");
    return lines;
}

}  // namespace render
