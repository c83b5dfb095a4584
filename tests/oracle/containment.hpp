// containment.hpp - does a node, as it is stored, contain a ray; does a sphere contain a
// triangle. In long double and without any tolerance: rounding outwards is the library's job.
#pragma once

#include <rsh/rsh_types.h>

#include "rays/types.h"
#include "support/mesh.hpp"

namespace oracle {

struct Node {
    test::Float3 apex;
    float radius;
    test::Float3 axis;
    float sine;
};

// Child `k` (0 .. 3) of a quad.
Node child_of(const cone_node4& quad, uint32_t k);

bool starts_inside(const Node& node, const rsh_ray& ray);
bool points_inside(const Node& node, const rsh_ray& ray);

// A node of the shape `box`.
struct BoxNode {
    test::Float3 origin_low, origin_high, direction_low, direction_high;
    float tmax;
};
BoxNode child_of(const box_node16& tile, uint32_t k);

// With room around `start` of `margin` on every side.
bool contains(const BoxNode& node, test::Long3 start, long double margin,
              test::Float3 direction);

bool sphere_contains(const cl_float4& sphere, const test::Corners& corners);

}  // namespace oracle
