// ray.hpp - rays and hits of oracles that trace on by themselves, in double precision.
#pragma once

#include <limits>

#include <rsh/rsh_types.h>

#include "support/vec.hpp"

namespace oracle {

// As rsh_ray.
struct Ray {
    test::Double3 origin, direction;
    double tmin = 0, tmax = std::numeric_limits<double>::infinity();
    uint32_t skip = RSH_NO_HIT;  // a triangle that it does not hit

    Ray(test::Double3 from, test::Double3 along) : origin(from), direction(along) {}
    Ray(const rsh_ray& r)
        : origin(r.origin_tmin.s[0], r.origin_tmin.s[1], r.origin_tmin.s[2]),
          direction(r.direction_tmax.s[0], r.direction_tmax.s[1], r.direction_tmax.s[2]),
          tmin(std::fmax(double(r.origin_tmin.s[3]), 0.0)),
          tmax(r.direction_tmax.s[3]) {}
};

// As rsh_hit.
struct Hit {
    double t = 0, u = 0, v = 0;
    uint32_t primitive = RSH_NO_HIT;

    Hit() = default;
    Hit(const rsh_hit& h) : t(h.t), u(h.u), v(h.v), primitive(h.primitive) {}
};

}  // namespace oracle
