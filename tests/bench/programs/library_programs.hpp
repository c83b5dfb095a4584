// library_programs.hpp - how the library puts a program together: what it does not export. Apart
// from all else of rsh-bench, because <rsh/rsh.hpp> has another rsh::Error than the library inside.
#pragma once

#include <CL/cl.h>

#include <string>

namespace bench {

// Of kernels/STEM.cl, its includes expanded; from RSH_KERNEL_DIR if that is set. Throws
// std::exception.
std::string program_source(const std::string& stem);
// What the library compiles for on a device where nobody asks for another.
cl_uint default_vector_width(cl_device_id device);
// Of every program on the device, before its own.
std::string base_options(cl_device_id device, cl_uint vector_width);

}  // namespace bench
