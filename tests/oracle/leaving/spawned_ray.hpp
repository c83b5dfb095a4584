// spawned_ray.hpp - what rsh_spawn may and must make of one hit, by rsh.h and by Snell: whether there
// is a ray, its direction and the side that it starts on. Calculates in long double, decides sides
// exactly, and shares no code with the kernels. Flat shading; what the ray hits is judged elsewhere.
#pragma once

#include "oracle/judge.hpp"

namespace oracle {

struct SpawnedRay {
    rsh_ray ray;
    cl_float4 weight;  // not of a shadow ray
    uint32_t skip;
};

// A ray that hit a triangle.
struct Sight {
    rsh_ray ray;
    rsh_hit hit;
    test::Corners corners;
    rsh_material material;
};

bool has_nan(const SpawnedRay& spawned);

// Where nothing is spawned.
bool is_none(const SpawnedRay& spawned);

// kMissed: no ray where one must be, or one that starts in the surface, or behind it. kSpurious: a
// ray where none may be, or with another direction or weight, or that starts too far away.
Verdict judge_reflected(const Sight& sight, const SpawnedRay& spawned);
Verdict judge_refracted(const Sight& sight, const SpawnedRay& spawned);
// Of a point light that casts shadows; the material is diffuse.
Verdict judge_shadow(const Sight& sight, const rsh_light& light, const SpawnedRay& spawned);

}  // namespace oracle
