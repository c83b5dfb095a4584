/* cones.cl - the bounds of rays/build_cones.cl, rays/cone_sphere.h and bvh/spheres.cl. */

RSH_DEFINE_CONE_SPHERE(measured_meet, float, int)

static float3 unit_in(const float* input) {
    return unit3(vector_in(input));
}

static void direction_input(uint* random, float* input) {
    const float scale = power_random(random, -60, 60);
    for (uint i = 0; i < 3; ++i)
        input[i] = scale * power_random(random, -8, 0) * hard_random(random);
}

static bool is_direction(const float* input, float3* axis) {
    if (!are_moderate(input, 3, 90) || !(largest3(fabs(vector_in(input))) > 0.0f)) return false;
    rsh_ray ray;
    ray.origin_tmin = (float4)(0.0f);
    ray.direction_tmax = (float4)(vector_in(input), INFINITY);
    *axis = ray_cone(ray).axis;
    return true;
}

static float cone_axis_error(const float* input, float most) {
    float3 axis;
    if (!is_direction(input, &axis)) return -1.0f;
    const float3 none = (float3)(0.0f);
    return sine_between(wide3_of(axis, none), wide3_of(vector_in(input), none)) / UNIT;
}

static float axis_length_error(const float* input, float most) {
    float3 axis;
    if (!is_direction(input, &axis)) return -1.0f;
    return fabs(length_of(convert_double3(axis)) - 1.0) / UNIT;
}

#define cone_axis_input direction_input
#define axis_length_input direction_input
DEFINE_SEARCH(cone_axis, 3)
DEFINE_SEARCH(axis_length, 3)

/* Four siblings: apex, axis, radius and sine of each. */
#define SIBLINGS 32

static void siblings_input(uint* random, float* input) {
    const float3 middle = hard_vector(random);
    const float width = power_random(random, -20, 0), radius = power_random(random, -24, 0);
    const float sine = power_random(random, -20, 0);
    for (uint k = 0; k < 4; ++k) {
        store_vector(power_random(random, -8, 8) * hard_vector(random), input + 8 * k);
        store_vector(middle + width * hard_vector(random), input + 8 * k + 3);
        input[8 * k + 6] = chance(random, 3) ? 0.0f : radius * unit_random(random);
        input[8 * k + 7] = sine * unit_random(random);
    }
}

static bool are_siblings(const float* input, cone_node* child, cone_node* parent) {
    if (!are_moderate(input, SIBLINGS, 40)) return false;
    cone_node4 quad;
    for (uint k = 0; k < 4; ++k) {
        child[k].apex = vector_in(input + 8 * k);
        child[k].axis = unit_in(input + 8 * k + 3);
        child[k].radius = input[8 * k + 6];
        child[k].sine = input[8 * k + 7];
        if (!(child[k].radius >= 0.0f) || !(child[k].sine >= 0.0f && child[k].sine <= 1.0f) ||
            !(largest3(fabs(child[k].axis)) > 0.0f))
            return false;
        set_quad_member(&quad, k, child[k]);
    }
    *parent = merge(&quad);
    return true;
}

/* What of the padding of cone_sine is needed. */
static float cone_sine_error(const float* input, float most) {
    cone_node child[4], parent;
    if (!are_siblings(input, child, &parent) || parent.sine > 1.0f) return -1.0f;
    const float3 none = (float3)(0.0f);
    const wide3 axis = wide3_of(parent.axis, none);
    double widest = 0.0;
    for (uint k = 0; k < 4; ++k) {
        const double sine = sine_between(wide3_of(child[k].axis, none), axis);
        const double alpha = child[k].sine;
        widest =
            fmax(widest, sine * sqrt(1.0 - alpha * alpha) + sqrt(1.0 - sine * sine) * alpha);
    }
    return fmax(64.0 - (parent.sine - widest) / UNIT, 0.0);
}

/* What of the last padding of cone_radius is needed, relative to the radius. */
static float cone_radius_error(const float* input, float most) {
    cone_node child[4], parent;
    if (!are_siblings(input, child, &parent) || !isfinite(parent.radius)) return -1.0f;
    double radius = 0.0;
    for (uint k = 0; k < 4; ++k)
        radius = fmax(radius, length_of(difference3(child[k].apex, parent.apex)) +
                                  (double)child[k].radius);
    if (!(radius > 0.0)) return -1.0f;
    return fmax(16.0 - (parent.radius / radius - 1.0) / UNIT, 0.0);
}

#define cone_sine_input siblings_input
#define cone_radius_input siblings_input
DEFINE_SEARCH(cone_sine, SIBLINGS)
DEFINE_SEARCH(cone_radius, SIBLINGS)

static float up(double value) {
    const float nearest = value;
    return nearest >= value ? nearest : as_float(as_int(nearest) + 1);
}

static double farthest_corner(triangle_points p, float3 centre) {
    return fmax(
        length_of(difference3(p.v0, centre)),
        fmax(length_of(difference3(p.v1, centre)), length_of(difference3(p.v2, centre))));
}

/* What of the padding of triangle_radius is needed. */
static float sphere_radius_error(const float* input, float most) {
    if (!are_moderate(input, AIMED, 40)) return -1.0f;
    const triangle_points p = triangle_in(input + 6);
    const float3 centre = sphere_centre(p);
    const double farthest = farthest_corner(p, centre);
    if (!is_finite3(centre) || !(farthest > 0.0)) return -1.0f;
    return fmax(64.0 - (triangle_radius(p, centre) / farthest - 1.0) / UNIT, 0.0);
}

#define sphere_radius_input aimed_input
DEFINE_SEARCH(sphere_radius, AIMED)

/* The padding that cone_sphere.h needs, in u (|w| + S), to keep a hit of a ray that just lies in its
 * cone, with a sphere that is just large enough. Behind the ray and triangle an axis. */
#define CONED (AIMED + 3)

/* At corners that are the farthest, past the sphere, the axis on the other side of the ray. */
static void cone_sphere_input(uint* random, float* input) {
    aimed_input(random, input);
    const triangle_points p = triangle_in(input + 6);
    const float3 centre = sphere_centre(p),
                 corner = vector_in(input + 6 + 3 * below(random, 3));
    const float3 outward = unit3(corner - centre),
                 away = unit3(cross3(hard_vector(random), outward));
    const float3 origin =
        corner - power_random(random, -4, 4) * safe_length(corner - centre) * away;
    store_vector(origin, input);
    store_vector(corner - origin, input + 3);
    store_vector(away + power_random(random, -20, 3) * unit_random(random) * outward,
                 input + AIMED);
}

static float cone_sphere_error(const float* input, float most) {
    const rsh_ray ray = ray_in(input);
    const triangle_points p = triangle_in(input + 6);
    rsh_hit hit;
    if (!are_moderate(input, CONED, 40) || !is_active(ray) || !intersect_one(ray, p, &hit))
        return -1.0f;
    const float3 none = (float3)(0.0f), axis = unit_in(input + AIMED);
    const float3 d = ray.direction_tmax.xyz, centre = sphere_centre(p);
    if (!(largest3(fabs(axis)) > 0.0f) || !is_finite3(centre) || !(dot3(axis, d) > 0.0f))
        return -1.0f;
    const double sine = sine_between(wide3_of(axis, none), wide3_of(d, none));
    if (sine > 0.9986) return -1.0f;
    measured_meet_lanes lanes = {ray.origin_tmin.x,
                                 ray.origin_tmin.y,
                                 ray.origin_tmin.z,
                                 0.0f,
                                 axis.x,
                                 axis.y,
                                 axis.z,
                                 up(sine),
                                 centre.x,
                                 centre.y,
                                 centre.z,
                                 up(farthest_corner(p, centre)),
                                 0.0f};
    float low = fmax(most, 0.0f), high = 256.0f;
    lanes.pad = low * UNIT;
    if (measured_meet(&lanes)) return 0.0f;
    for (uint i = 0; i < 13; ++i) {
        const float middle = 0.5f * (low + high);
        lanes.pad = middle * UNIT;
        if (measured_meet(&lanes))
            high = middle;
        else
            low = middle;
    }
    return high < 256.0f ? high : INFINITY;
}
DEFINE_SEARCH(cone_sphere, CONED)
