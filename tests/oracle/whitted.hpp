// whitted.hpp - Whitted's shading of one hit in double precision, written from the comments of
// rsh_material, rsh_light and rsh_texture. Scalar, no acceleration; shares no code with
// kernels.
#pragma once

#include "oracle/ray.hpp"
#include "support/scene.hpp"

namespace oracle {

struct Surface {
    test::Double3 point;
    test::Double3 geometric;  // unit, on the side that the ray comes from
    test::Double3 normal;     // unit, for shading
    test::Double3 diffuse;    // with texture
    test::Double3 ambient;    // with texture
    rsh_material material;
    bool from_inside = false;  // the ray meets the back
};

Surface surface_at(const test::Scene& scene, const Ray& ray, const Hit& hit);

// What the surface sends out against `direction` by itself; bit k of `hidden` takes away light k.
test::Double3 sent_by(const test::Scene& scene, const Surface& surface, test::Double3 direction,
                      uint32_t hidden);

// What a ray sees that hits nothing.
test::Double3 environment_at(const test::Scene& scene, test::Double3 direction);

// Of the two, what the ray meets.
test::Double3 radiance(const test::Scene& scene, const Ray& ray, const Hit& hit,
                       uint32_t hidden);

// Unit vector towards the light; *distance is infinite for a directional one.
test::Double3 towards_light(const rsh_light& light, test::Double3 point, double* distance);

// The surface faces the light and is inside of its cone; other geometry does not count.
bool reaches(const rsh_light& light, const Surface& surface);

struct Secondary {
    bool exists = false;
    test::Double3 direction;  // unit
    test::Double3 weight;
};

Secondary reflected(const Surface& surface, const Ray& ray);
Secondary refracted(const Surface& surface, const Ray& ray);

// Repeat, bilinear; u to the right, v upwards.
test::Double3 texture_at(const test::Scene& scene, uint32_t texture, double u, double v);

}  // namespace oracle
