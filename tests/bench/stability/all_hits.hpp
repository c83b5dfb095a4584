// all_hits.hpp - what the query all answers, and what brute force answers to all queries.
#pragma once

#include <rsh/rsh.h>

#include <vector>

namespace bench::stability {

// Of each ray, in order.
struct AllHits {
    std::vector<cl_ulong> offsets;  // one more than there are rays
    std::vector<rsh_hit> hits;

    size_t count(size_t ray) const { return size_t(offsets[ray + 1] - offsets[ray]); }
    const rsh_hit* of(size_t ray) const { return hits.data() + offsets[ray]; }
};

struct Reference {
    std::vector<rsh_hit> closest;
    AllHits all;
};

}  // namespace bench::stability
