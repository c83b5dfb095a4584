#include "device/cl/context.hpp"

#include <algorithm>
#include <cstdlib>

#include "device/error.hpp"

namespace rsh {
namespace {

cl::Device checked_device(const cl::Context& context, cl_device_id device) {
    for (const cl::Device& known : context.getInfo<CL_CONTEXT_DEVICES>())
        if (known() == device) return known;
    throw Error(RSH_INVALID_VALUE, "device: is not one of the context's devices");
}

cl::Buffer zeroed_word(const cl::Context& context) {
    cl_uint zero = 0;
    return {context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, sizeof zero, &zero};
}

cl_uint checked_width(cl_uint requested, const DeviceCaps& caps) {
    if (requested == 0) return caps.is_cpu ? caps.vector_width : 1;
    if (requested == 1 || requested == 4 || requested == 8 || requested == 16) return requested;
    throw Error(RSH_INVALID_VALUE, "vector_width: is ", requested,
                ", must be 0, 1, 4, 8 or 16");
}

std::string build_options(cl_uint vector_width, const DeviceCaps& caps) {
    std::string options = "-cl-std=CL1.2 -D RSH_WIDTH=" + std::to_string(vector_width);
    if (caps.correctly_rounded) options += " -cl-fp32-correctly-rounded-divide-sqrt";
    return options;
}

std::string kernel_folder(const char* requested) {
    if (requested) return requested;
    const char* folder = std::getenv("RSH_KERNEL_DIR");
    return folder ? folder : "";
}

std::vector<cl::Platform> all_platforms() {
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        platforms.clear();  // the loader reports an empty list as an error
    }
    if (platforms.empty())
        throw Error(RSH_NO_DEVICE,
                    "no OpenCL platform: is a driver installed (Debian: pocl-opencl-icd)?");
    return platforms;
}

std::vector<cl::Device> devices_of(const cl::Platform& platform) {
    std::vector<cl::Device> devices;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error&) {
        devices.clear();  // a platform without devices is skipped
    }
    return devices;
}

}  // namespace

Context::Context(const rsh_context_desc& desc)
    : cl(desc.context, true),
      device(checked_device(cl, desc.device)),
      caps(device),
      vector_width(checked_width(desc.vector_width, caps)),
      log(desc.log, desc.log_user),
      programs(cl, device, caps, log, build_options(vector_width, caps),
               BinaryCache::folder_for(desc.cache_dir), kernel_folder(desc.kernel_dir)),
      pool(cl),
      wrong_buffers_(zeroed_word(cl)) {}

cl::Device find_device(const char* name) {
    if (!name) name = std::getenv("RSH_DEVICE");
    const std::string wanted = name ? name : "";
    std::string seen;
    for (const cl::Platform& platform : all_platforms())
        for (const cl::Device& device : devices_of(platform)) {
            const std::string label =
                platform.getInfo<CL_PLATFORM_NAME>() + ": " + device.getInfo<CL_DEVICE_NAME>();
            if (label.find(wanted) != std::string::npos) return device;
            seen += (seen.empty() ? "" : ", ") + label;
        }
    throw Error(RSH_NO_DEVICE, "name: no device contains \"", wanted,
                "\"; there are: ", seen.empty() ? "none" : seen);
}

}  // namespace rsh
