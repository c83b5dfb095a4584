// check_fields.hpp - checks of fields that several descriptors have. The files check_*.cpp
// alone include it.
#pragma once

#include "api/check.hpp"

namespace rsh {

// Rays of one call. Rounded up to whole work-groups, their number still fits 32 bits.
constexpr cl_uint kMaxRays = 1u << 28;
constexpr cl_uint kMaxSide = 16384;

// A buffer of the context that holds at least `bytes`; may be NULL only if `bytes` is 0.
void check_buffer(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes);
// The same, where NULL means that there is none.
void check_optional(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes);
// The same for scratch memory, where NULL means the pool.
void check_scratch(const Context& context, cl_mem scratch, size_t bytes);

void check_vector(const char* field, const rsh_float4& v);
void check_budget(size_t budget);
void check_min_weight(float weight);

}  // namespace rsh
