/* camera.cl - the paddings of camera/project.h and lib/camera/screen.cpp: how far a pixel's ray is
 * turned, and what of both paddings a triangle needs that a pixel's ray hits at a corner. The screen is
 * set up here as screen.cpp does it. */

/* forward, right, down, eye; column, row, width, height. */
#define CAMERA 16

static void camera_input(uint* random, float* input) {
    for (uint i = 0; i < 3; ++i)
        store_vector(power_random(random, -3, 3) * hard_vector(random), input + 3 * i);
    store_vector(power_random(random, -8, 8) * hard_vector(random), input + 9);
    const uint width = 1 + below(random, 16384), height = 1 + below(random, 16384);
    input[12] = chance(random, 2) ? 0.0f : (float)below(random, width);
    input[13] = chance(random, 2) ? 0.0f : (float)below(random, height);
    input[14] = (float)width;
    input[15] = (float)height;
}

typedef struct exact_rows {
    double3 depth, across, down;
} exact_rows;

static double sum_of_sizes(double3 v) {
    return fabs(v.x) + fabs(v.y) + fabs(v.z);
}
static float4 rounded4(double3 v, double w) {
    return convert_float4((double4)(v, w));
}

/* Sets the screen, with paddings in units of `pad`, in place of 2^-17. False: no camera. */
static bool is_camera(const float* input, float pad, screen_setup* screen, exact_rows* rows) {
    if (!are_moderate(input, CAMERA, 40)) return false;
    for (uint i = 12; i < 16; ++i)
        if (!(input[i] >= 0.0f && input[i] <= 16384.0f && floor(input[i]) == input[i]))
            return false;
    if (!(input[12] < input[14] && input[13] < input[15])) return false;
    float3 axis[3];
    float size = 0.0f;
    for (uint i = 0; i < 3; ++i) size = fmax(size, largest3(fabs(vector_in(input + 3 * i))));
    if (!(size > 0.0f)) return false;
    for (uint i = 0; i < 3; ++i) axis[i] = 0.5f * scale_to_one(size) * vector_in(input + 3 * i);
    const double3 forward = convert_double3(axis[0]), right = convert_double3(axis[1]),
                  down = convert_double3(axis[2]), depth = cross(right, down);
    const double inverse = 1.0 / dot(forward, depth);
    *rows = (exact_rows){inverse * depth, inverse * cross(down, forward),
                         inverse * cross(forward, right)};
    const double of_depth = sum_of_sizes(rows->depth);
    const double across = 0x1p-17 * (sum_of_sizes(rows->across) + of_depth);
    const double below = 0x1p-17 * (sum_of_sizes(rows->down) + of_depth);
    if (!(of_depth <= 0x1p10 && across <= 1.0 && below <= 1.0)) return false;
    screen->eye_near = (float4)(vector_in(input + 9), 0.0f);
    screen->forward_far = (float4)(axis[0], INFINITY);
    screen->right = (float4)(axis[1], 0.0f);
    screen->down = (float4)(axis[2], 0.0f);
    screen->depth_row = rounded4(rows->depth, of_depth);
    screen->across_row = rounded4(rows->across, sum_of_sizes(rows->across));
    screen->down_row = rounded4(rows->down, sum_of_sizes(rows->down));
    screen->across_padding = pad * across;
    screen->down_padding = pad * below;
    screen->near_depth = 0.0f;
    screen->picture_width = (uint)input[14];
    screen->picture_height = (uint)input[15];
    /* A window that begins halfway to the pixel. */
    screen->first_x = (uint)input[12] / 2;
    screen->first_y = (uint)input[13] / 2;
    screen->width = screen->picture_width - screen->first_x;
    screen->height = screen->picture_height - screen->first_y;
    screen->padding = as_uint(pad * 0x1p-18f); /* in place of the constant in corner_of */
    return true;
}

static float3 pixel_direction(const float* input, const screen_setup* screen) {
    const uint x = (uint)input[12] - screen->first_x, y = (uint)input[13] - screen->first_y;
    float direction[3];
    pixel_directions(screen, &x, &y, direction);
    return (float3)(direction[0], direction[1], direction[2]);
}

/* In units of u of the sums of the rows' sizes. */
static float pixel_turn_error(const float* input, float most) {
    screen_setup screen;
    exact_rows rows;
    if (!is_camera(input, 1.0f, &screen, &rows)) return -1.0f;
    const double3 d = convert_double3(pixel_direction(input, &screen));
    const double depth = dot(rows.depth, d);
    if (!(depth > 0.0)) return INFINITY;
    const double x = (2.0 * input[12] + 1.0 - input[14]) / input[14];
    const double y = (2.0 * input[13] + 1.0 - input[15]) / input[15];
    const double of_depth = sum_of_sizes(rows.depth);
    return fmax(fabs(dot(rows.across, d) / depth - x) / (sum_of_sizes(rows.across) + of_depth),
                fabs(dot(rows.down, d) / depth - y) / (sum_of_sizes(rows.down) + of_depth)) /
           UNIT;
}
#define pixel_turn_input camera_input
DEFINE_SEARCH(pixel_turn, CAMERA)

/* Behind the camera a triangle. */
#define PICTURED (CAMERA + 9)

static void projection_input(uint* random, float* input) {
    screen_setup screen;
    exact_rows rows;
    camera_input(random, input);
    const bool is_good = is_camera(input, 1.0f, &screen, &rows);
    const float3 way = is_good ? pixel_direction(input, &screen) : hard_vector(random);
    const float far = power_random(random, -8, 8);
    const float3 corner = vector_in(input + 9) + far * way;
    for (uint i = 0; i < 3; ++i) {
        const float3 off = far * power_random(random, -12, 2) * hard_vector(random);
        store_vector(i == 0 ? corner : corner + off, input + CAMERA + 3 * i);
    }
}

static bool is_pictured(const float* input, float pad) {
    screen_setup screen;
    exact_rows rows;
    is_camera(input, pad, &screen, &rows);
    const ushort4 box = project(&screen, triangle_in(input + CAMERA));
    const uint x = (uint)input[12] - screen.first_x, y = (uint)input[13] - screen.first_y;
    return x >= box.x && x <= box.z && y >= box.y && y <= box.w;
}

/* As a share of both paddings. */
static float projection_error(const float* input, float most) {
    screen_setup screen;
    exact_rows rows;
    if (!are_moderate(input + CAMERA, 9, 40) || !is_camera(input, 1.0f, &screen, &rows))
        return -1.0f;
    rsh_ray ray;
    rsh_hit hit;
    ray.origin_tmin = screen.eye_near;
    ray.direction_tmax = (float4)(pixel_direction(input, &screen), INFINITY);
    if (!is_active(ray) || !intersect_one(ray, triangle_in(input + CAMERA), &hit)) return -1.0f;
    float low = fmax(most, 0.0f), high = 2.0f;
    if (is_pictured(input, low)) return 0.0f;
    if (!is_pictured(input, high)) return INFINITY;
    for (uint i = 0; i < 12; ++i) {
        const float middle = 0.5f * (low + high);
        if (is_pictured(input, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}
DEFINE_SEARCH(projection, PICTURED)
