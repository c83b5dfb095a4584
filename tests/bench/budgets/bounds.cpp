#include "budgets/bound.hpp"

namespace bench::budgets {

// docs/numerics.md derives each.
const std::vector<Bound>& all_bounds() {
    static const std::vector<Bound> bounds = {
        {"difference_of_products", "algebra", 4, "mesh/intersect.h", "u", 2, 0, 2},
        {"difference_in_ulps", "algebra", 4, "mesh/intersect.h", "ulp/2", 3, 0, 3},
        {"cross_in_ulps", "algebra", 4, "mesh/algebra.h", "ulp/2", 3, 0, 3},
        {"safe_length", "algebra", 3, "mesh/triangles.h", "u", 4.5, 13.5, 16},
        {"twofold_dot", "algebra", 12, "mesh/twofold.h", "u^2 terms", 21, 0, 64},
        {"twofold_cross", "algebra", 12, "mesh/twofold.h", "u^2 terms", 19, 0, 64},
        {"sheared_coordinate", "hits", 15, "mesh/intersect.h", "u reach", 6, 10, 11},
        {"hit_depth", "hits", 15, "mesh/intersect.h", "u reach", 12, 20, 20},
        {"hit_axis", "hits", 15, "mesh/intersect.h", "u reach", 18, 30, 31},
        {"hit_distance", "hits", 15, "mesh/intersect.h", "u reach", 28.2, 46.95, 47},
        {"box_pad", "boxes", 15, "rays/box_node.h", "u size", 22, 38, 64},
        {"cone_axis", "cones", 3, "rays/build_cones.cl", "u", 2, 10, 16},
        {"axis_length", "cones", 3, "rays/build_cones.cl", "u", 3.5, 12.5, 16},
        {"cone_sine", "cones", 32, "rays/build_cones.cl", "u", 26, 48, 64},
        {"cone_radius", "cones", 32, "rays/build_cones.cl", "u", 3, 3, 16},
        {"sphere_radius", "cones", 15, "bvh/spheres.cl", "u", 7.5, 16.5, 64},
        {"cone_sphere", "cones", 18, "rays/cone_sphere.h", "u size", 53, 84, 128},
        {"plane_height", "leaving", 15, "mesh/leaving.h", "u^2 terms", 40, 0, 64},
        {"plane_side", "leaving", 15, "mesh/leaving.h", "u^2 terms", 40, 0, 64},
        {"may_separate", "leaving", 24, "mesh/leaving.h", "u size", 38, 0, 64},
        {"pixel_turn", "camera", 16, "lib/camera/screen.cpp", "u rows", 65, 65, 128},
        {"projection", "camera", 25, "camera/project.h", "paddings", 1, 1, 1},
        {"barycentric_point", "spawn", 15, "surface/departure.h", "u extent", 5.2, 0, 8},
        {"departure_point", "spawn", 15, "surface/departure.h", "its own", 1, 1, 1},
        {"origin_side", "spawn", 18, "surface/start.h", "margin", 1, 1, 1},
        {"origin_distance", "spawn", 18, "surface/start.h", "ulp", 2, 2, 2},
        {"mirror", "spawn", 9, "surface/mirror.h", "u", 1.001, 1.001, 2},
        {"grazing", "spawn", 6, "surface/grazing.h", "of 2^-16", 1.033, 1.033, 1.033},
    };
    return bounds;
}

}  // namespace bench::budgets
