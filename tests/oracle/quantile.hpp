// quantile.hpp - the value that a share of values does not exceed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace oracle {

// Infinite ones are the largest. Of at least one value.
inline double quantile(std::vector<double> all, double share) {
    const size_t last = all.size() - 1;
    const auto at = all.begin() + std::lround(share * double(last));
    std::nth_element(all.begin(), at, all.end());
    return *at;
}

}  // namespace oracle
