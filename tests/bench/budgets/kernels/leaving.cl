/* leaving.cl - the bounds of mesh/leaving.h: on which side of a plane through a ray's origin a corner
 * is. A plane is that of a triangle. */

/* Triangle, origin, corner. */
#define SIDED 15

static void plane_height_input(uint* random, float* input) {
    aimed_input(random, input);
    for (uint i = 0; i < 9; ++i) input[i] = input[6 + i];
    const float3 a = vector_in(input), b = vector_in(input + 3), c = vector_in(input + 6);
    store_vector(a + signed_random(random) * (b - a) + signed_random(random) * (c - a),
                 input + 9);
    store_vector(a + signed_random(random) * (b - a) + signed_random(random) * (c - a),
                 input + 12);
    if (chance(random, 2)) input[9 + below(random, 6)] += hard_random(random);
}

/* In units of u^2 of the sum of all terms' sizes: of the normal's and of its product with the corner.
 * As side_of does it. */
static float plane_height_error(const float* input, float most) {
    if (!are_moderate(input, SIDED, 30)) return -1.0f;
    const triangle_points p = triangle_in(input);
    const scaled_edges edges = edges_of(p);
    const twofold3 normal = plane_normal(p);
    const twofold3 to_corner = exact_sum3(vector_in(input + 12), -vector_in(input + 9));
    const twofold height = twofold_dot(normal, to_corner);
    const wide3 a = wide3_of(edges.edge1.high, edges.edge1.low);
    const wide3 b = wide3_of(edges.edge2.high, edges.edge2.low);
    const wide3 c = wide3_of(to_corner.high, to_corner.low);
    const wide exact = wide_dot(wide_cross(a, b), c);
    const double3 i = fabs(rounded3(a)), j = fabs(rounded3(b)), k = fabs(rounded3(c));
    const double terms = k.x * (i.y * j.z + i.z * j.y) + k.y * (i.z * j.x + i.x * j.z) +
                         k.z * (i.x * j.y + i.y * j.x);
    if (!(terms > 0.0)) return -1.0f;
    const wide found = {-(double)height.high, -(double)height.low};
    return fabs(wide_sum(exact, found).high) / (UNIT * UNIT * terms);
}
DEFINE_SEARCH(plane_height, SIDED)

/* Triangle of the plane, ray, triangle: that separates ray and triangle. */
#define SEPARATED 24

static void may_separate_input(uint* random, float* input) {
    aimed_input(random, input + 9);
    for (uint i = 0; i < 9; ++i) input[i] = input[15 + i];
    const float3 a = vector_in(input), b = vector_in(input + 3) - a;
    const float3 c = vector_in(input + 6) - a;
    for (uint i = 0; i < 4; ++i) /* origin and corners in the plane */
        store_vector(a + signed_random(random) * b + signed_random(random) * c,
                     input + (i == 0 ? 9 : 12 + 3 * i));
    if (chance(random, 2))
        store_vector(signed_random(random) * b + signed_random(random) * c, input + 12);
}

static wide wide3_height(wide3 normal, float3 from, float3 to) {
    return wide_dot(normal, wide3_of(to, -from));
}

static int sign_of(wide value) {
    const double v = value.high != 0.0 ? value.high : value.low;
    return v > 0.0 ? 1 : v < 0.0 ? -1 : 0;
}

/* The threshold with which may_separate says so, in u |a| |b| |corner - origin|. It takes it in place
 * of the ray's tmin. */
static float may_separate_error(const float* input, float most) {
    if (!are_moderate(input, SEPARATED, 30)) return -1.0f;
    const triangle_points plane = triangle_in(input), p = triangle_in(input + 15);
    rsh_ray ray = ray_in(input + 9);
    const float3 none = (float3)(0.0f), origin = ray.origin_tmin.xyz;
    const wide3 normal =
        wide_cross(wide3_of(plane.v1, -plane.v0), wide3_of(plane.v2, -plane.v0));
    const int ahead = sign_of(wide_dot(normal, wide3_of(ray.direction_tmax.xyz, none)));
    if (ahead == 0 || ahead * sign_of(wide3_height(normal, origin, p.v0)) > 0 ||
        ahead * sign_of(wide3_height(normal, origin, p.v1)) > 0 ||
        ahead * sign_of(wide3_height(normal, origin, p.v2)) > 0)
        return -1.0f;
    float low = fmax(most, 0.0f), high = 256.0f;
    ray.origin_tmin.w = low * UNIT;
    if (may_separate(plane, ray, p)) return 0.0f;
    for (uint i = 0; i < 13; ++i) {
        const float middle = 0.5f * (low + high);
        ray.origin_tmin.w = middle * UNIT;
        if (may_separate(plane, ray, p))
            high = middle;
        else
            low = middle;
    }
    return high < 256.0f ? high : INFINITY;
}
DEFINE_SEARCH(may_separate, SEPARATED)
