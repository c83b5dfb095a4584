/* hits.cl - the bounds of mesh/intersect.h. `reach` is the largest component of a corner, seen from
 * the ray's origin. */

typedef struct exact_corners {
    double3 corner[3]; /* from the origin; x, y across the ray's largest axis, z along it */
    double3 direction;
    double reach;
} exact_corners;

static double3 along_axis(sheared_rays r, double3 v) {
    return r.kz_is_x ? v.yzx : r.kz_is_y ? v.zxy : v;
}

static exact_corners exactly_seen(sheared_rays r, const float* input) {
    exact_corners seen;
    seen.reach = 0.0;
    seen.direction = along_axis(r, convert_double3(vector_in(input + 3)));
    for (uint i = 0; i < 3; ++i) {
        const double3 from_origin = difference3(vector_in(input + 6 + 3 * i), vector_in(input));
        seen.corner[i] = along_axis(r, from_origin);
        seen.reach = fmax(seen.reach, largest_of3(from_origin));
    }
    return seen;
}

static sheared_rays sheared_in(const float* input) {
    return shear_rays(input[0], input[1], input[2], input[3], input[4], input[5], 0.0f,
                      INFINITY);
}

static ray_space_corners corners_in(sheared_rays r, const float* input) {
    float corner[9];
    for (uint i = 0; i < 9; ++i) corner[i] = input[6 + i];
    return to_ray_space(r, corner);
}

static bool is_aimed(const float* input) {
    return are_moderate(input, AIMED, 40) && largest3(fabs(vector_in(input + 3))) > 0.0f;
}

/* A coordinate across the ray, in units of its own corner's reach. */
static float sheared_coordinate_error(const float* input, float most) {
    if (!is_aimed(input)) return -1.0f;
    const sheared_rays r = sheared_in(input);
    const ray_space_corners s = corners_in(r, input);
    const exact_corners seen = exactly_seen(r, input);
    const double2 found[3] = {(double2)(s.ax, s.ay), (double2)(s.bx, s.by),
                              (double2)(s.cx, s.cy)};
    double error = 0.0;
    for (uint i = 0; i < 3; ++i) {
        const double reach = largest_of3(seen.corner[i]);
        const double2 exact =
            seen.corner[i].xy - seen.direction.xy / seen.direction.z * seen.corner[i].z;
        const double2 off = fabs(found[i] - exact);
        if (reach > 0.0) error = fmax(error, fmax(off.x, off.y) / (UNIT * reach));
    }
    return error;
}

/* The point of the triangle that a hit stands for: by the exact weights of the corners as they were
 * rounded in the plane across the ray. False: no hit. */
static bool point_hit(const float* input, sheared_rays r, const exact_corners* seen,
                      double3* point, float* t) {
    float corner[9];
    for (uint i = 0; i < 9; ++i) corner[i] = input[6 + i];
    const lane_hits hits = intersect(r, corner);
    if (!hits.is_hit) return false;
    const ray_space_corners s = corners_in(r, input);
    const wide U =
        wide_determinant((wide){s.cx, 0}, (wide){s.by, 0}, (wide){s.cy, 0}, (wide){s.bx, 0});
    const wide V =
        wide_determinant((wide){s.ax, 0}, (wide){s.cy, 0}, (wide){s.ay, 0}, (wide){s.cx, 0});
    const wide W =
        wide_determinant((wide){s.bx, 0}, (wide){s.ay, 0}, (wide){s.by, 0}, (wide){s.ax, 0});
    const double sum = U.high + V.high + W.high;
    *point =
        (U.high * seen->corner[0] + V.high * seen->corner[1] + W.high * seen->corner[2]) / sum;
    *t = hits.t;
    return true;
}

/* How far the hit, origin + t * direction, is from that point. */
static bool is_hit_off(const float* input, double3* off) {
    if (!is_aimed(input)) return false;
    const sheared_rays r = sheared_in(input);
    const exact_corners seen = exactly_seen(r, input);
    double3 point;
    float t;
    if (!point_hit(input, r, &seen, &point, &t)) return false;
    *off = fabs((double)t * seen.direction - point) / (UNIT * seen.reach);
    return true;
}

static float hit_depth_error(const float* input, float most) {
    double3 off;
    return is_hit_off(input, &off) ? off.z : -1.0f;
}

static float hit_axis_error(const float* input, float most) {
    double3 off;
    return is_hit_off(input, &off) ? largest_of3(off) : -1.0f;
}

static float hit_distance_error(const float* input, float most) {
    double3 off;
    return is_hit_off(input, &off) ? length_of(off) : -1.0f;
}

#define sheared_coordinate_input aimed_input
#define hit_depth_input aimed_input
#define hit_axis_input aimed_input
#define hit_distance_input aimed_input
DEFINE_SEARCH(sheared_coordinate, AIMED)
DEFINE_SEARCH(hit_depth, AIMED)
DEFINE_SEARCH(hit_axis, AIMED)
DEFINE_SEARCH(hit_distance, AIMED)
