// pass_on.cpp - the two functions that a loader looks for; CL/cl_layer.h.
#include "support/layers/pass_on.hpp"

#include <cstring>

namespace layer {

cl_icd_dispatch below = {};

namespace {

cl_icd_dispatch calls = {};
constexpr cl_uint kCalls = sizeof calls / sizeof(void*);

}  // namespace
}  // namespace layer

extern "C" {

cl_int CL_API_CALL clGetLayerInfo(cl_layer_info what, size_t size, void* value,
                                  size_t* needed) {
    const cl_layer_api_version version = CL_LAYER_API_VERSION_100;
    if (what != CL_LAYER_API_VERSION || (value && size < sizeof version))
        return CL_INVALID_VALUE;
    if (value) std::memcpy(value, &version, sizeof version);
    if (needed) *needed = sizeof version;
    return CL_SUCCESS;
}

cl_int CL_API_CALL clInitLayer(cl_uint count, const cl_icd_dispatch* target, cl_uint* own_count,
                               const cl_icd_dispatch** own) {
    if (count < layer::kCalls || !target || !own_count || !own) return CL_INVALID_VALUE;
    layer::below = layer::calls = *target;
    layer::change(layer::calls);
    *own_count = layer::kCalls;
    *own = &layer::calls;
    return CL_SUCCESS;
}

}  // extern "C"
