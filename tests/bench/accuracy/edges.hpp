// edges.hpp - which pixels lie at edges of what is seen: there a picture with one sample per pixel is
// wrong however exact it is.
#pragma once

#include <cstdint>
#include <vector>

#include "support/vec.hpp"

namespace bench::accuracy {

// What the centre of a pixel sees.
struct Seen {
    uint32_t material = 0xffffffff;  // nothing is seen
    test::Double3 point;
    test::Double3 normal;  // unit, of the triangle
    double distance = 0;   // from the eye
};

// Those with another material among their eight neighbours, or with a point there that is farther from
// their own triangle's plane than 2 % of the distance. Edges in mirrors and of shadows are none.
std::vector<bool> find_edges(const std::vector<Seen>& seen, uint32_t width);

}  // namespace bench::accuracy
