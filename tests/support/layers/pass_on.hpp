// pass_on.hpp - what every OpenCL layer of the tests has. A layer stands between a program and its
// driver where the loader's OPENCL_LAYERS names it; it passes on every call that it does not change.
// What it changes is in a file of its own, which defines `change`.
#pragma once

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 300
#endif
#include <CL/cl_layer.h>

namespace layer {

// The same calls one layer further down.
extern cl_icd_dispatch below;

// Replaces the calls that this layer changes.
void change(cl_icd_dispatch& calls);

}  // namespace layer
