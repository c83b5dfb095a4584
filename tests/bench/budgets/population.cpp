#include <algorithm>
#include <numeric>

#include "budgets/search.hpp"

namespace bench::budgets {

size_t Population::largest() const {
    return size_t(std::max_element(worst.begin(), worst.end()) - worst.begin());
}

void Population::breed() {
    std::vector<size_t> rank(items());
    std::iota(rank.begin(), rank.end(), size_t{0});
    std::stable_sort(rank.begin(), rank.end(),
                     [this](size_t a, size_t b) { return worst[a] > worst[b]; });
    const size_t half = items() / 2, best = std::max<size_t>(1, items() / 8);
    for (size_t i = half; i < items(); ++i) {
        if (i % 2) {
            worst[rank[i]] = -1.0f;
            continue;
        }
        const size_t from = rank[i / 2 % best], to = rank[i];
        worst[to] = worst[from];
        std::copy_n(inputs.begin() + std::ptrdiff_t(from * width), width,
                    inputs.begin() + std::ptrdiff_t(to * width));
    }
}

}  // namespace bench::budgets
