#include "api/check_fields.hpp"

#include <cmath>

namespace rsh {

void check_buffer(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes) {
    if (bytes == 0 && !buffer) return;
    require_not_null(buffer, field);
    const cl::Buffer wrapped(buffer, true);
    if (wrapped.getInfo<CL_MEM_CONTEXT>()() != context.cl())
        throw Error(RSH_INVALID_VALUE, std::string(field) +
                                           ": is of another cl_context, must be of the "
                                           "rsh_context's");
    const cl_ulong actual = wrapped.getInfo<CL_MEM_SIZE>();
    if (actual < bytes)
        throw Error(RSH_BUFFER_TOO_SMALL, std::string(field) + ": holds " +
                                              std::to_string(actual) + " bytes, needs " +
                                              std::to_string(bytes));
}

void check_optional(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes) {
    if (buffer) check_buffer(context, field, buffer, bytes);
}

void check_scratch(const Context& context, cl_mem scratch, size_t bytes) {
    if (scratch) check_buffer(context, "scratch", scratch, bytes);
    if (bytes > context.caps.max_allocation)
        throw Error(RSH_UNSUPPORTED, "scratch: needs " + std::to_string(bytes) +
                                         " bytes, the device allocates at most " +
                                         std::to_string(context.caps.max_allocation));
}

void check_vector(const char* field, const rsh_float4& v) {
    for (int i = 0; i < 3; ++i) require(std::isfinite(v.s[i]), field, v.s[i], "finite");
}

void check_budget(size_t budget) {
    require(budget == 0 || budget >= RSH_MIN_BUDGET, "budget", budget,
            "0 or at least " + std::to_string(RSH_MIN_BUDGET));
}

void check_min_weight(float weight) {
    require(weight >= 0 && std::isfinite(weight), "min_weight", weight, "finite, not negative");
}

}  // namespace rsh
