// spawned.hpp - what rays were made of, beside the rays themselves.
#pragma once

#include "stability/family.hpp"

namespace bench::stability {

struct Spawned {
    test::Rays seen;  // what hit
    std::vector<rsh_hit> hits;
    std::vector<cl_float4> weights;  // of what is spawned; 0 for shadow rays
};

}  // namespace bench::stability
