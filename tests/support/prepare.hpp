// prepare.hpp - rsh_prepare in tests: an empty descriptor, and what a context counts.
#pragma once

#include "support/device.hpp"

namespace test {

inline rsh_prepare_desc prepare_desc() {
    rsh_prepare_desc desc = {};
    desc.struct_size = sizeof desc;
    return desc;
}

inline rsh_statistics statistics_of(rsh_context context) {
    rsh_statistics sums = {};
    sums.struct_size = sizeof sums;
    RSH_CHECK(rsh_get_statistics(context, &sums));
    return sums;
}

// Compiled or loaded so far.
inline cl_ulong programs_of(rsh_context context) {
    const rsh_statistics sums = statistics_of(context);
    return sums.programs_built + sums.programs_loaded;
}

}  // namespace test
