// patch.hpp - curved and flat surfaces as functions of (u, v), tessellated to a wanted number
// of triangles in all. Knows no object; furniture.hpp makes objects out of patches.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <vector>

#include "model/model.hpp"

namespace render {

struct SurfacePoint {
    glm::vec3 position;
    glm::vec3 normal;  // outwards
};

// A grid of columns x rows quads over the unit square; a row that is one point (a pole) has one
// triangle per column instead of two.
struct Patch {
    std::function<SurfacePoint(float u, float v)> at;
    uint32_t material = 0;
    glm::vec2 size{1.0f};   // lengths along u and v [world]: the grid's proportions
    float detail = 1.0f;    // columns and rows per length, relative to other patches
    int least_columns = 1;  // fewest that still show the shape
    int least_rows = 1;
    bool starts_at_pole = false;  // the row v = 0 is one point
    bool ends_at_pole = false;    // so is the row v = 1
};

// One mesh of exactly or, by less than the smallest grid row, nearly `triangles` triangles,
// finer where patches ask for detail. Throws when even the coarsest grids have more.
Mesh tessellate(const std::vector<Patch>& patches, int64_t triangles);

}  // namespace render
