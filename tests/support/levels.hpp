// levels.hpp - which rays a node holds, from the shape of a hierarchy of any branching.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <rsh/rsh_types.h>

namespace test {

// Rays along one side of a node of `level`.
inline uint64_t side_of(const ray_levels& levels, uint32_t level) {
    uint64_t side = 1;
    for (uint32_t l = 0; l < level; ++l) side *= levels.branching;
    return side;
}

// The rays below node (x, y) of `level`; a list has y = 0.
inline std::vector<size_t> rays_below(const ray_levels& levels, uint32_t level, uint32_t x,
                                      uint32_t y) {
    std::vector<size_t> rays;
    const uint64_t side = side_of(levels, level);
    const uint64_t across = levels.is_list ? side * side : side;
    const uint64_t last_x = std::min<uint64_t>((x + 1) * across, levels.width[0]);
    const uint64_t last_y = std::min<uint64_t>((y + 1) * side, levels.height[0]);
    for (uint64_t v = y * side; v < last_y; ++v)
        for (uint64_t u = x * across; u < last_x; ++u) rays.push_back(v * levels.width[0] + u);
    return rays;
}

// Index of child k of node `parent` of level + 1; -1: outside of the level.
inline int64_t child_of(const ray_levels& levels, uint32_t level, uint32_t parent, uint32_t k,
                        uint32_t* x, uint32_t* y) {
    const uint32_t branching = levels.branching, above = levels.width[level + 1];
    *x = levels.is_list ? branching * branching * parent + k
                        : parent % above * branching + k % branching;
    *y = levels.is_list ? 0 : parent / above * branching + k / branching;
    if (*x >= levels.width[level] || *y >= levels.height[level]) return -1;
    return int64_t(*y) * levels.width[level] + *x;
}

}  // namespace test
