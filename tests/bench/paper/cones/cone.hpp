// cone.hpp - the paper's node over rays on the host, in doubles: a cone whose apex is a ball, its merge, and
// which points, spheres and triangles its rays may meet.
#pragma once

#include <glm/glm.hpp>

#include <vector>

#include <rsh/rsh_types.h>

namespace bench::paper {

// Rays start in the ball about `apex` and run along `axis`, at most `angle` off it.
struct Cone {
    glm::dvec3 apex{0.0}, axis{0.0};
    double radius = -1;  // below 0: there is no ray
    double angle = 0;

    bool is_empty() const { return radius < 0; }
    bool meets_all() const;  // 90 degrees and wider: no test tells anything
};

Cone cone_of(const rsh_ray& ray);

// Encloses all of them; not the smallest that does.
Cone merge(const std::vector<Cone>& children);

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 0;
};

using Triangle = glm::dvec3[3];

// The smallest.
Sphere sphere_of(const Triangle& triangle);

// The paper's test, with the case of spheres behind the apex.
bool meets(const Cone& cone, const Sphere& sphere);

// Exact but for rounding.
bool meets(const Cone& cone, const Triangle& triangle);

}  // namespace bench::paper
