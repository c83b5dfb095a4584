// inside.hpp - compares what is inside by the parity of counts with what is by solid angles.
#pragma once

#include <rsh/rsh.h>

#include <string>
#include <vector>

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace bench::parity {

struct Inside {
    uint64_t points = 0, inside = 0;
    uint64_t near = 0;   // nearer to the surface than a hit may be off: either answer is right
    uint64_t wrong = 0;  // of the others
    std::string why;     // the first of these
};

// Of each ray's origin; counts: of the triangles that it crosses. Solid angles are found once.
class Judge {
public:
    Judge(const test::Mesh& mesh, const test::Rays& rays);
    Inside compare(const std::vector<cl_uint>& counts) const;

private:
    bool is_near(size_t ray) const;

    const test::Mesh& mesh_;
    const test::Rays& rays_;
    std::vector<int8_t> turns_;  // odd: inside; kOpen: the solid angles do not say
};

}  // namespace bench::parity
