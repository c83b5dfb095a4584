#include "device/cl/context.hpp"

#include <algorithm>
#include <cstdlib>

#include "device/error.hpp"
#include "device/no_device.hpp"

namespace rsh {
namespace {

cl_device_id checked_device(cl_context context, cl_device_id device) {
    for (const cl_device_id known : info_list<cl_device_id>(context, CL_CONTEXT_DEVICES))
        if (known == device) return device;
    throw Error(RSH_INVALID_VALUE, "device: is not one of the context's devices");
}

Buffer zeroed_word(cl_context context) {
    const cl_uint zero = 0;
    return new_buffer(context, CL_MEM_READ_WRITE, sizeof zero, &zero);
}

cl_uint checked_width(cl_uint requested, const DeviceCaps& caps) {
    if (requested == 0) return caps.default_width();
    if (requested == 1 || requested == 4 || requested == 8 || requested == 16) return requested;
    throw Error(RSH_INVALID_VALUE, "vector_width: is ", requested,
                ", must be 0, 1, 4, 8 or 16");
}

size_t checked_variants(cl_uint requested) {
    if (requested == 0) return RSH_MAX_VARIANTS;
    if (requested == RSH_NO_VARIANTS) return 0;
    if (requested <= RSH_MAX_VARIANTS) return requested;
    throw Error(RSH_INVALID_VALUE, "max_variants: is ", requested, ", must be at most ",
                RSH_MAX_VARIANTS, ", or RSH_NO_VARIANTS");
}

std::string kernel_folder(const char* requested) {
    if (requested) return requested;
    const char* folder = std::getenv("RSH_KERNEL_DIR");
    return folder ? folder : "";
}

// The loader reports an empty list as an error.
std::vector<cl_platform_id> all_platforms() {
    cl_uint count = 0;
    if (linked_functions().clGetPlatformIDs(0, nullptr, &count) != CL_SUCCESS) count = 0;
    std::vector<cl_platform_id> platforms(count);
    if (count == 0 ||
        linked_functions().clGetPlatformIDs(count, platforms.data(), nullptr) != CL_SUCCESS)
        throw Error(RSH_NO_DEVICE,
                    "no OpenCL platform: is a driver installed (Debian: pocl-opencl-icd)?");
    return platforms;
}

// A platform without devices is skipped.
std::vector<cl_device_id> devices_of(cl_platform_id platform) {
    constexpr cl_device_type kAll = CL_DEVICE_TYPE_ALL;
    cl_uint count = 0;
    if (opencl(platform).clGetDeviceIDs(platform, kAll, 0, nullptr, &count) != CL_SUCCESS)
        return {};
    std::vector<cl_device_id> devices(count);
    if (opencl(platform).clGetDeviceIDs(platform, kAll, count, devices.data(), nullptr) !=
        CL_SUCCESS)
        return {};
    return devices;
}

}  // namespace

Context::Context(const rsh_context_desc& desc)
    : cl(Handle<cl_context>::retained(desc.context)),
      device(checked_device(desc.context, desc.device)),
      caps(device),
      vector_width(checked_width(desc.vector_width, caps)),
      log(desc.log, desc.log_user),
      programs(desc.context, device, caps, log, caps.build_options(vector_width),
               {BinaryCache::folder_for(desc.cache_dir), desc.cache_bytes,
                kernel_folder(desc.kernel_dir)}),
      variants(programs, log, checked_variants(desc.max_variants)),
      pool(desc.context),
      wrong_buffers_(zeroed_word(desc.context)),
      preparer(programs, log) {}

KernelName Context::for_call(const KernelName& name) {
    if (variants.is_to_follow(name)) preparer.follow(name);
    return variants.for_call(name);
}

cl_device_id find_device(const char* name) {
    if (!name) name = std::getenv("RSH_DEVICE");
    const std::string wanted = name ? name : "";
    std::string seen, platforms;
    for (const cl_platform_id platform : all_platforms()) {
        const std::string platform_name = info_text(platform, CL_PLATFORM_NAME);
        platforms += (platforms.empty() ? "" : ", ") + platform_name;
        for (const cl_device_id device : devices_of(platform)) {
            const std::string label = platform_name + ": " + info_text(device, CL_DEVICE_NAME);
            if (label.find(wanted) != std::string::npos) return device;
            seen += (seen.empty() ? "" : ", ") + label;
        }
    }
    if (seen.empty()) throw Error(RSH_NO_DEVICE, no_device_text(platforms));
    throw Error(RSH_NO_DEVICE, "name: no device contains \"", wanted, "\"; there are: ", seen);
}

}  // namespace rsh
