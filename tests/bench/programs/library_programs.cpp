#include "programs/library_programs.hpp"

#include <cstdlib>

#include "device/cl/device_caps.hpp"
#include "device/programs/kernel_source.hpp"

namespace bench {

std::string program_source(const std::string& stem) {
    const char* folder = std::getenv("RSH_KERNEL_DIR");
    return rsh::kernel_source(stem, folder ? folder : "");
}

cl_uint default_vector_width(cl_device_id device) {
    return rsh::DeviceCaps(device).default_width();
}

std::string base_options(cl_device_id device, cl_uint vector_width) {
    return rsh::DeviceCaps(device).build_options(vector_width);
}

}  // namespace bench
