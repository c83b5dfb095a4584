/* boxes.cl - the padding of boxes and origins that rays/box_node.h derives: the smallest with which a
 * packet of one ray meets the box of a triangle that it hits, as far as its hit. Without RSH_RAISED,
 * so that the padding pays for all roundings. */

/* In front of 64 and of a pad in units of u, in place of 2^-18 in pad_of. */
static float pad_of_units(float units, float largest) {
    return units * 0x1p-24f * largest + 0x1p-124f;
}

static bool is_box_met(rsh_ray ray, triangle_points p, float t, float units) {
    const float3 low = fmin(p.v0, fmin(p.v1, p.v2)), high = fmax(p.v0, fmax(p.v1, p.v2));
    const float3 origin = ray.origin_tmin.xyz, direction = ray.direction_tmax.xyz;
    const float pad = pad_of_units(units, largest3(fmax(fabs(low), fabs(high))));
    const float origin_pad = pad_of_units(units, largest3(fabs(origin)));
    const float side[4][3] = {{low.x, low.y, low.z},
                              {high.x, high.y, high.z},
                              {origin.x, origin.y, origin.z},
                              {direction.x, direction.y, direction.z}};
    interval_packet packet;
    boxes16 boxes;
    for (uint axis = 0; axis < 3; ++axis) {
        const float o = side[2][axis], d = side[3][axis];
        packet.slab[axis] = slab_of(o - origin_pad, o + origin_pad, d, d);
        for (uint k = 0; k < 16; ++k) {
            boxes.low[axis][k] = side[0][axis] - pad;
            boxes.high[axis][k] = side[1][axis] + pad;
        }
    }
    packet.limit = t;
    return boxes_met(&packet, &boxes, 0) & 1u;
}

/* Triangles whose box is flat, mostly: every error of a hit takes it out of such a box. */
static void box_pad_input(uint* random, float* input) {
    aimed_input(random, input);
    if (chance(random, 4)) return;
    const uint axis = below(random, 3);
    input[9 + axis] = input[12 + axis] = input[6 + axis];
}

static float box_pad_error(const float* input, float most) {
    const rsh_ray ray = ray_in(input);
    const triangle_points p = triangle_in(input + 6);
    rsh_hit hit;
    if (!are_moderate(input, AIMED, 40) || !is_active(ray) || !intersect_one(ray, p, &hit))
        return -1.0f;
    float low = fmax(most, 0.0f), high = 128.0f;
    if (is_box_met(ray, p, hit.t, low)) return 0.0f;
    if (!is_box_met(ray, p, hit.t, high)) return INFINITY;
    for (uint i = 0; i < 12; ++i) {
        const float middle = 0.5f * (low + high);
        if (is_box_met(ray, p, hit.t, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}
DEFINE_SEARCH(box_pad, AIMED)
