// opencl.hpp - OpenCL's functions for an object: opencl(queue).clFlush(queue). They are those of the
// loader that rsh is linked to, but for objects that it cannot call; then they are the driver's.
//
// A process may hold several loaders, as pyopencl brings its own. cl_khr_icd 2.0.0 makes that a
// trap: a loader of that version calls the driver through a table that it left in the platform when
// it listed the platforms, and that objects inherit. An older loader leaves none, so the contexts that it
// makes have none, and a newer one that meets them jumps to nowhere. The driver's own table, through
// which the older loader made them, is there in both versions.
#pragma once

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>
#include <CL/cl_icd.h>

#include <cstdint>

namespace rsh {

// What every object of a driver for loaders begins with.
struct ObjectHead {
    const cl_icd_dispatch* functions;
    const void* loader_functions;  // only with the mark below
};

// In place of a function that is not called through the table: "OPENCL31", or "CL31", in ASCII.
constexpr std::intptr_t kLoaderCallsMark =
    static_cast<std::intptr_t>(sizeof(void*) == 4 ? 0x434C3331 : 0x4F50454E434C3331);

// NULL: the loader's are to be called.
inline const cl_icd_dispatch* driver_functions(const void* object) noexcept {
    const auto* const head = static_cast<const ObjectHead*>(object);
    if (!head || !head->functions) return nullptr;
    const auto mark = reinterpret_cast<std::intptr_t>(head->functions->clGetPlatformIDs);
    return mark == kLoaderCallsMark && !head->loader_functions ? head->functions : nullptr;
}

// Those that the library calls; all others are NULL.
const cl_icd_dispatch& linked_functions() noexcept;

inline const cl_icd_dispatch& opencl(const void* object) noexcept {
    const cl_icd_dispatch* const own = driver_functions(object);
    return own ? *own : linked_functions();
}

}  // namespace rsh
