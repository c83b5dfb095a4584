#include "api/check_fields.hpp"

#include <cmath>

namespace rsh {

void check_reserved(const char* field, const cl_uint* words, size_t count) {
    for (size_t i = 0; i < count; ++i) require(words[i] == 0, field, words[i], "0");
}

void check_vector(const char* field, const rsh_float4& v) {
    for (int i = 0; i < 3; ++i) require(std::isfinite(v.s[i]), field, v.s[i], "finite");
}

void check_ray_grid(cl_uint width, cl_uint height) {
    if (height <= 1) {
        require(width <= kMaxRays, "width", width, "at most ", kMaxRays);
        return;
    }
    require(width >= 1 && width <= kMaxSide, "width", width, "1 .. ", kMaxSide, " in a grid");
    require(height <= kMaxSide, "height", height, "at most ", kMaxSide);
}

void check_budget(size_t budget) {
    require(budget == 0 || budget >= RSH_MIN_BUDGET, "budget", budget, "0 or at least ",
            RSH_MIN_BUDGET);
}

void check_min_weight(float weight) {
    require(weight >= 0 && std::isfinite(weight), "min_weight", weight, "finite, not negative");
}

void refuse(const void* given, const char* field, const char* with) {
    if (given) throw Error(RSH_INVALID_VALUE, field, ": is set, must be NULL with ", with);
}

}  // namespace rsh
