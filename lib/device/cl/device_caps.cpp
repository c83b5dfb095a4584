#include "device/cl/device_caps.hpp"

#include <algorithm>

#include "device/error.hpp"

namespace rsh {
namespace {

std::string identity_of(cl_device_id device) {
    const auto platform = info<cl_platform_id>(device, CL_DEVICE_PLATFORM);
    return info_text(platform, CL_PLATFORM_NAME) + '\n' +
           info_text(platform, CL_PLATFORM_VERSION) + '\n' + info_text(device, CL_DEVICE_NAME) +
           '\n' + info_text(device, CL_DEVICE_VERSION) + '\n' +
           info_text(device, CL_DRIVER_VERSION);
}

// What the compiler prefers is no guide: where it vectorizes across work-items that is 1.
cl_uint register_width(cl_device_id device) {
    const cl_uint native = info<cl_uint>(device, CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT);
    for (const cl_uint width : {16u, 8u, 4u})
        if (native >= width) return width;
    return 1;
}

void require_supported(cl_device_id device) {
    if (!info<cl_bool>(device, CL_DEVICE_COMPILER_AVAILABLE))
        throw Error(RSH_UNSUPPORTED, "device: has no OpenCL C compiler, one is required");
    if (!info<cl_bool>(device, CL_DEVICE_ENDIAN_LITTLE))
        throw Error(RSH_UNSUPPORTED, "device: is big-endian, little-endian is required");
    const std::string version = info_text(device, CL_DEVICE_OPENCL_C_VERSION);
    if (version.compare(0, 11, "OpenCL C 1.") == 0 && version[11] < '2')
        throw Error(RSH_UNSUPPORTED, "device: has ", version, ", OpenCL C 1.2 is required");
}

}  // namespace

DeviceCaps::DeviceCaps(cl_device_id device) {
    require_supported(device);
    is_cpu = (info<cl_device_type>(device, CL_DEVICE_TYPE) & CL_DEVICE_TYPE_CPU) != 0;
    correctly_rounded = (info<cl_device_fp_config>(device, CL_DEVICE_SINGLE_FP_CONFIG) &
                         CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
    vector_width = register_width(device);
    compute_units = info<cl_uint>(device, CL_DEVICE_MAX_COMPUTE_UNITS);
    max_group_size = info<size_t>(device, CL_DEVICE_MAX_WORK_GROUP_SIZE);
    group_size = std::min<size_t>(64, max_group_size);
    // CL_DEVICE_MEM_BASE_ADDR_ALIGN counts bits; 64 bytes keep parts off shared cache lines.
    alignment = std::max<size_t>(64, info<cl_uint>(device, CL_DEVICE_MEM_BASE_ADDR_ALIGN) / 8);
    max_allocation = info<cl_ulong>(device, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
    memory = info<cl_ulong>(device, CL_DEVICE_GLOBAL_MEM_SIZE);
    identity = identity_of(device);
}

std::string DeviceCaps::build_options(cl_uint width) const {
    std::string options = "-cl-std=CL1.2 -D RSH_WIDTH=" + std::to_string(width);
    if (correctly_rounded) options += " -cl-fp32-correctly-rounded-divide-sqrt";
    return options;
}

}  // namespace rsh
