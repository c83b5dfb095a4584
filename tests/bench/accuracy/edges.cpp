#include "accuracy/edges.hpp"

namespace bench::accuracy {
namespace {

constexpr double kMostHeight = 0.02;  // over the distance from the eye

bool goes_on(const Seen& from, const Seen& to) {
    if (from.material != to.material) return false;
    return std::fabs(dot(from.normal, to.point - from.point)) <= kMostHeight * from.distance;
}

}  // namespace

std::vector<bool> find_edges(const std::vector<Seen>& seen, uint32_t width) {
    const int64_t columns = width, rows = int64_t(seen.size()) / columns;
    const auto at = [&](int64_t x, int64_t y) { return seen[size_t(y * columns + x)]; };
    std::vector<bool> is_edge(seen.size());
    for (int64_t i = 0; i < int64_t(seen.size()); ++i)
        for (int k = 0; k < 9; ++k) {
            const int64_t x = i % columns + k % 3 - 1, y = i / columns + k / 3 - 1;
            if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
            if (!goes_on(seen[size_t(i)], at(x, y))) is_edge[size_t(i)] = true;
        }
    return is_edge;
}

}  // namespace bench::accuracy
