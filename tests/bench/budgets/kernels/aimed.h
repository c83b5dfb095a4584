/* aimed.h - a ray at a triangle, 15 numbers: origin, direction, three corners. */
#ifndef BUDGETS_AIMED_H
#define BUDGETS_AIMED_H

#define AIMED 15

static float3 hard_vector(uint* random) {
    return (float3)(hard_random(random), hard_random(random), hard_random(random)) *
           (float3)(signed_random(random), signed_random(random), signed_random(random));
}

static void store_vector(float3 v, float* to) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

/* Fat triangles, slivers, small ones far off; aimed at the inside, edges and corners, from near
 * and far and from along the plane. */
static void aimed_input(uint* random, float* input) {
    const float size = power_random(random, -8, 8);
    float3 corner[3];
    for (uint i = 0; i < 3; ++i) corner[i] = size * hard_vector(random);
    if (chance(random, 3))
        corner[2] = corner[0] + unit_random(random) * (corner[1] - corner[0]) +
                    power_random(random, -20, -1) * corner[2];
    if (chance(random, 4)) {
        const float3 away = size * power_random(random, 0, 10) * hard_vector(random);
        for (uint i = 0; i < 3; ++i) corner[i] += away;
    }
    float u = chance(random, 4) ? power_random(random, -24, -1) : unit_random(random);
    float v = chance(random, 4) ? power_random(random, -24, -1) : unit_random(random);
    if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
    const float3 target = corner[0] + u * (corner[1] - corner[0]) + v * (corner[2] - corner[0]);
    float3 away = size * power_random(random, -6, 6) * hard_vector(random);
    if (chance(random, 4)) /* nearly in the plane */
        away = signed_random(random) * (corner[1] - corner[0]) +
               signed_random(random) * (corner[2] - corner[0]) +
               power_random(random, -16, -2) * away;
    const float3 origin = target + away;
    store_vector(origin, input);
    store_vector(power_random(random, -8, 8) * (target - origin), input + 3);
    for (uint i = 0; i < 3; ++i) store_vector(corner[i], input + 6 + 3 * i);
}

static rsh_ray ray_in(const float* input) {
    rsh_ray ray;
    ray.origin_tmin = (float4)(vector_in(input), 0.0f);
    ray.direction_tmax = (float4)(vector_in(input + 3), INFINITY);
    return ray;
}

static triangle_points triangle_in(const float* input) {
    return (triangle_points){vector_in(input), vector_in(input + 3), vector_in(input + 6)};
}

#endif
