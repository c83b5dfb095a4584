/* spawn.cl - the bounds of surface/departure.h, surface/start.h, surface/mirror.h and surface/grazing.h. */

/* One lane. */
static float3v lane_of(float3 v) {
    return (float3v){v.x, v.y, v.z};
}
static float3 from_lane(float3v v) {
    return (float3)(v.x, v.y, v.z);
}

/* The surface that a ray meets, as far as departures look at it. */
static bool surface_in(const float* input, surface_lanes* surface, ray_lanes* block) {
    const rsh_ray ray = ray_in(input);
    const triangle_points triangle = triangle_in(input + 6);
    rsh_hit hit;
    if (!are_moderate(input, AIMED, 30) || !is_active(ray) ||
        !intersect_one(ray, triangle, &hit))
        return false;
    block->origin = lane_of(ray.origin_tmin.xyz);
    block->direction = lane_of(ray.direction_tmax.xyz);
    block->t = hit.t;
    block->u = hit.u;
    block->v = hit.v;
    surface->v0 = lane_of(triangle.v0);
    surface->v1 = lane_of(triangle.v1);
    surface->v2 = lane_of(triangle.v2);
    surface->edges = edges_of_lanes(surface);
    const float3v normal = triangle_normals(&surface->edges);
    surface->geometric =
        dot_v(normal, unit_v(block->direction)) <= 0.0f ? normal : opposite_v(normal);
    return largest_v(fabs_v(normal)) > 0.0f;
}

static wide3 exact_normal(triangle_points p) {
    return wide_cross(wide3_of(p.v1, -p.v0), wide3_of(p.v2, -p.v0));
}

/* How far a point is from the triangle's plane, to the normal's side. */
static double plane_distance(triangle_points p, float3 point, float3 rest) {
    const wide3 normal = exact_normal(p);
    const wide3 from_v0 = wide3_sum(wide3_of(point, rest), wide3_of(-p.v0, (float3)(0.0f)));
    return wide_dot(normal, from_v0).high / length_of(rounded3(normal));
}

static float barycentric_point_error(const float* input, float most) {
    surface_lanes surface;
    ray_lanes block;
    departure_lanes from;
    if (!surface_in(input, &surface, &block)) return -1.0f;
    take_barycentric_points(&surface, &block, 0, &from);
    return fabs(plane_distance(triangle_in(input + 6), from_lane(from.point),
                               from_lane(from.rest))) /
           (UNIT * surface.edges.extent);
}

/* In units of the error that the departure itself says it has. */
static float departure_point_error(const float* input, float most) {
    surface_lanes surface;
    ray_lanes block;
    if (!surface_in(input, &surface, &block)) return -1.0f;
    const departure_lanes from = departures_of(&surface, &block);
    return fabs(plane_distance(triangle_in(input + 6), from_lane(from.point),
                               from_lane(from.rest))) /
           from.error;
}

#define barycentric_point_input aimed_input
#define departure_point_input aimed_input
DEFINE_SEARCH(barycentric_point, AIMED)
DEFINE_SEARCH(departure_point, AIMED)

/* Behind ray and triangle the direction of the ray that leaves. */
#define LEAVING (AIMED + 3)

static void leaving_input(uint* random, float* input) {
    aimed_input(random, input);
    store_vector(hard_vector(random), input + AIMED);
    if (chance(random, 2)) /* flat over the triangle */
        store_vector(signed_random(random) * (vector_in(input + 9) - vector_in(input + 6)) +
                         signed_random(random) * (vector_in(input + 12) - vector_in(input + 6)),
                     input + AIMED);
}

typedef struct leaving_ray {
    surface_lanes surface;
    departure_lanes from;
    float3 origin;
} leaving_ray;

static bool leaving_in(const float* input, leaving_ray* leaving) {
    ray_lanes block;
    if (!are_moderate(input + AIMED, 3, 30) || !surface_in(input, &leaving->surface, &block))
        return false;
    const float3v side = leaving->surface.geometric;
    const float3v direction = keep_on_side(unit_v(lane_of(vector_in(input + AIMED))), side);
    if (!(largest_v(fabs_v(direction)) > 0.0f)) return false;
    leaving->from = departures_of(&leaving->surface, &block);
    leaving->origin = from_lane(rounded_to_side(
        leave_surfaces(&leaving->surface, &leaving->from, side, true), side, direction));
    return true;
}

/* Whether the origin is on its side of the plane: above 1 it is not. In units of the margin that it
 * was given. */
static float origin_side_error(const float* input, float most) {
    leaving_ray leaving;
    if (!leaving_in(input, &leaving)) return -1.0f;
    const triangle_points p = triangle_in(input + 6);
    const double height = plane_distance(p, leaving.origin, (float3)(0.0f));
    const double3 side = convert_double3(from_lane(leaving.surface.geometric));
    const bool is_outside = dot(rounded3(exact_normal(p)), side) > 0.0;
    const double margin = 2.0 * leaving.from.error + 0x1p-124;
    return fmax(1.0 - (is_outside ? height : -height) / margin, 0.0);
}

/* How far from the point it is moved on an axis, in ulp of the largest coordinate, beside the margin. */
static float origin_distance_error(const float* input, float most) {
    leaving_ray leaving;
    if (!leaving_in(input, &leaving)) return -1.0f;
    const float3 point = from_lane(leaving.from.point), rest = from_lane(leaving.from.rest);
    const double3 moved =
        rounded3(wide3_sum(wide3_of(leaving.origin, -point), wide3_of(-rest, (float3)(0.0f))));
    const double largest = largest_of3(convert_double3(point));
    if (!(largest >= 0x1p-40)) return -1.0f;
    return fmax(largest_of3(moved) - 2.0 * leaving.from.error, 0.0) / (2.0 * half_ulp(largest));
}

#define origin_side_input leaving_input
#define origin_distance_input leaving_input
DEFINE_SEARCH(origin_side, LEAVING)
DEFINE_SEARCH(origin_distance, LEAVING)

/* A direction, a normal, what the normal's floats left. */
#define MIRRORED 9

static void mirror_input(uint* random, float* input) {
    for (uint i = 0; i < 6; ++i) input[i] = power_random(random, -6, 0) * hard_random(random);
    for (uint i = 6; i < 9; ++i) input[i] = signed_random(random);
}

static float mirror_error(const float* input, float most) {
    if (!are_moderate(input, 6, 20) || !are_moderate(input + 6, 3, 60)) return -1.0f;
    const float3 d = vector_in(input), n = vector_in(input + 3);
    const float size = largest3(fabs(n));
    if (!(size >= 0x1p-10f && size <= 0x1p10f && largest3(fabs(d)) >= 0x1p-10f)) return -1.0f;
    const float3 rest = clamp(vector_in(input + 6), -1.0f, 1.0f) * (0x1p-24f * fabs(n));
    const twofold3v normal = {lane_of(n), lane_of(rest)};
    const float3 none = (float3)(0.0f), found = from_lane(mirrored(lane_of(d), normal));
    const wide3 exact_d = wide3_of(d, none), exact_n = wide3_of(n, rest);
    const wide dn = wide_dot(exact_d, exact_n), nn = wide_dot(exact_n, exact_n);
    const wide3 exact = wide3_sum(wide3_scaled(nn, exact_d),
                                  wide3_scaled((wide){-2.0 * dn.high, -2.0 * dn.low}, exact_n));
    return sine_between(wide3_of(found, none), exact) / UNIT;
}
DEFINE_SEARCH(mirror, MIRRORED)

/* RSH_GRAZING over the cosine between the direction kept and the side. */
static void grazing_input(uint* random, float* input) {
    for (uint i = 0; i < 6; ++i) input[i] = hard_random(random) * unit_random(random);
    input[2] = -(input[0] * input[3] + input[1] * input[4]) / input[5];
    input[2] += power_random(random, -24, -12) * hard_random(random);
}

static float grazing_error(const float* input, float most) {
    if (!are_moderate(input, 6, 20)) return -1.0f;
    const float3 given = unit3(vector_in(input)), side = unit3(vector_in(input + 3));
    if (!(largest3(fabs(given)) > 0.0f) || !(largest3(fabs(side)) > 0.0f)) return -1.0f;
    const double3 d = convert_double3(from_lane(keep_on_side(lane_of(given), lane_of(side)))),
                  n = convert_double3(side);
    const double cosine = dot(d, n) / (length_of(d) * length_of(n));
    return cosine > 0.0 ? RSH_GRAZING / cosine : INFINITY;
}
DEFINE_SEARCH(grazing, 6)
