/* leaving.cl - the bounds of mesh/leaving.h: on which side of a plane through a ray's origin a corner
 * is. A plane is that of a triangle. */

/* Triangle, origin, corner. */
#define SIDED 15

static void plane_side_input(uint* random, float* input) {
    aimed_input(random, input);
    for (uint i = 0; i < 9; ++i) input[i] = input[6 + i];
    const float3 a = vector_in(input), b = vector_in(input + 3), c = vector_in(input + 6);
    store_vector(a + signed_random(random) * (b - a) + signed_random(random) * (c - a),
                 input + 9);
    store_vector(a + signed_random(random) * (b - a) + signed_random(random) * (c - a),
                 input + 12);
    if (chance(random, 2)) input[9 + below(random, 6)] += hard_random(random);
}

/* The height of a corner above the plane, and in `unit` u^2 of the sum of all terms' sizes: of the
 * normal's and of its product with the corner. */
static double exact_height(triangle_points p, twofold3 to_corner, double* unit) {
    const scaled_edges edges = edges_of(from_shortest_edges(p));
    const wide3 a = wide3_of(edges.edge1.high, edges.edge1.low);
    const wide3 b = wide3_of(edges.edge2.high, edges.edge2.low);
    const wide3 c = wide3_of(to_corner.high, to_corner.low);
    const double3 i = fabs(rounded3(a)), j = fabs(rounded3(b)), k = fabs(rounded3(c));
    *unit = UNIT * UNIT *
            (k.x * (i.y * j.z + i.z * j.y) + k.y * (i.z * j.x + i.x * j.z) +
             k.z * (i.x * j.y + i.y * j.x));
    return wide_dot(wide_cross(a, b), c).high;
}

static float plane_height_error(const float* input, float most) {
    if (!are_moderate(input, SIDED, 30)) return -1.0f;
    const triangle_points p = triangle_in(input);
    const twofold3 to_corner = exact_sum3(vector_in(input + 12), -vector_in(input + 9));
    double unit;
    const double exact = exact_height(p, to_corner, &unit);
    if (!(unit > 0.0)) return -1.0f;
    const twofold found = twofold_dot(plane_of(p).normal, to_corner);
    return fabs((found.high - exact) + found.low) / unit;
}
#define plane_height_input plane_side_input
DEFINE_SEARCH(plane_height, SIDED)

/* What of its threshold a decision about the side needs: above 64 it is wrong. */
static float plane_side_error(const float* input, float most) {
    if (!are_moderate(input, SIDED, 30)) return -1.0f;
    const triangle_points p = triangle_in(input);
    const float3 origin = vector_in(input + 9), corner = vector_in(input + 12);
    double unit;
    const double height = exact_height(p, exact_sum3(corner, -origin), &unit);
    if (!(unit > 0.0)) return -1.0f;
    const triangle_plane plane = plane_of(p);
    const int side = side_of(&plane, origin, corner);
    return side ? fmax(64.0 - side * height / unit, 0.0) : 0.0;
}
DEFINE_SEARCH(plane_side, SIDED)

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
