/* build_fitted_cones.cl - the hierarchy over the rays with the bound `cone_fitted`, bottom-up.
 *   rays    in   level 0
 *   groups  out  nodes of all levels below the root, in groups of 16; see rsh_cone_group
 * "Choose loosely, measure exactly": apex and axis of a node are any good guess, from its rays
 * or its children; radius and spread are then the largest that any of its rays shows, measured
 * from the guess as stored and rounded outwards. So a parent is as tight as its guess allows,
 * whatever its children's cones add up to. Does not test anything against the scene.
 */
#include "rays/cone_fitted.h"
#include "rays/group_levels.h"
#include "rays/tile_layout.h"

/* 16 rays: where they start, or, converging, where t = 1; unit directions from there. */
typedef struct rsh_sheaf {
    floatv start[3][RSH_VECTORS], direction[3][RSH_VECTORS];
    floatv more[RSH_VECTORS];   /* radius that the start needs by itself */
    floatv spread[RSH_VECTORS]; /* 0, or RSH_ALL_DIRECTIONS: could go anywhere */
    intv is_active[RSH_VECTORS];
} rsh_sheaf;

static floatv largest_of(floatv x, floatv y, floatv z)
{
    return fmax(fabs(x), fmax(fabs(y), fabs(z)));
}

static intv are_finite(floatv x, floatv y, floatv z)
{
    return (x - x) + (y - y) + (z - z) == (floatv)(0.0f);
}

/* The same rays from their points at t = 1 backwards: thinnest where they meet. Every point
 * with t <= 1 lies that way; other rays go anywhere. The radius makes up for the sum, which
 * rounds by u per component, and for the hits of mesh/intersect.h: those are off by 45u of their
 * distance to the origin, which is the direction's length more than the distance to the start
 * that rays/cone_fitted.h allows for. */
static void reverse(rsh_sheaf* s, uint v, floatv tmax)
{
    floatv end[3], length = (floatv)(0.0f), at = (floatv)(0.0f);
    for (uint axis = 0; axis < 3; ++axis) {
        end[axis] = s->start[axis][v] + s->direction[axis][v];
        length += fabs(s->direction[axis][v]);
        at += fabs(end[axis]);
    }
    const intv is_reversible =
        (tmax <= (floatv)(1.0f)) & are_finite(end[0], end[1], end[2]);
    for (uint axis = 0; axis < 3; ++axis) {
        s->start[axis][v] = select(s->start[axis][v], end[axis], is_reversible);
        s->direction[axis][v] = -s->direction[axis][v];
    }
    s->more[v] = select((floatv)(0.0f), 0x1p-22f * at + 0x1p-18f * length + 0x1p-124f,
                        is_reversible);
    s->spread[v] = select((floatv)(RSH_ALL_DIRECTIONS), (floatv)(0.0f), is_reversible);
}

/* Normalising errs by at most 12u in angle, 16u in length (u = 2^-24), also where divisions err
 * by 2.5 ulp. A denormal direction may lose its bits to the division: anywhere, then. */
static void normalize_directions(rsh_sheaf* s, uint v)
{
    floatv d[3];
    const floatv scale =
        largest_of(s->direction[0][v], s->direction[1][v], s->direction[2][v]);
    for (uint axis = 0; axis < 3; ++axis) d[axis] = s->direction[axis][v] / scale;
    const floatv length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (uint axis = 0; axis < 3; ++axis) s->direction[axis][v] = d[axis] / length;
    s->spread[v] = select((floatv)(RSH_ALL_DIRECTIONS), s->spread[v],
                          scale >= (floatv)(0x1p-100f));
}

static void load_sheaf(rsh_sheaf* s, rsh_tile tile, uint block, uint is_converging,
                       __global const rsh_ray* rays)
{
    float lanes[8][16];
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(tile, block, k);
        float row[8];
        vstore8((float8)(NAN), 0, row);
        if (i != RSH_NO_RAY) {
            const rsh_ray ray = rays[i];
            vstore8((float8)(ray.origin_tmin, ray.direction_tmax), 0, row);
        }
        for (uint f = 0; f < 8; ++f) lanes[f][k] = row[f];
    }
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const uint at = RSH_WIDTH * v;
        for (uint axis = 0; axis < 3; ++axis) {
            s->start[axis][v] = load_lanes(lanes[axis] + at);
            s->direction[axis][v] = load_lanes(lanes[4 + axis] + at);
        }
        const floatv tmax = load_lanes(lanes[7] + at);
        const floatv x = s->direction[0][v], y = s->direction[1][v], z = s->direction[2][v];
        s->is_active[v] = are_finite(s->start[0][v], s->start[1][v], s->start[2][v]) &
                          are_finite(x, y, z) & (largest_of(x, y, z) > (floatv)(0.0f)) &
                          (load_lanes(lanes[3] + at) <= tmax);
        s->more[v] = s->spread[v] = (floatv)(0.0f);
        if (is_converging) reverse(s, v, tmax);
        normalize_directions(s, v);
    }
}

/* Where starts and directions lie: x y z of both. */
typedef struct rsh_extent {
    float low[6], high[6];
} rsh_extent;

static rsh_extent no_extent(void)
{
    rsh_extent e;
    for (uint f = 0; f < 6; ++f) {
        e.low[f] = INFINITY;
        e.high[f] = -INFINITY;
    }
    return e;
}

static void add_extent(rsh_extent* e, rsh_extent other)
{
    for (uint f = 0; f < 6; ++f) {
        e->low[f] = fmin(e->low[f], other.low[f]);
        e->high[f] = fmax(e->high[f], other.high[f]);
    }
}

static rsh_extent extent_of(const rsh_sheaf* s)
{
    rsh_extent e = no_extent();
    for (uint f = 0; f < 6; ++f) {
        floatv low = (floatv)(INFINITY), high = (floatv)(-INFINITY);
        for (uint v = 0; v < RSH_VECTORS; ++v) {
            const floatv value = f < 3 ? s->start[f][v] : s->direction[f - 3][v];
            low = fmin(low, select((floatv)(INFINITY), value, s->is_active[v]));
            high = fmax(high, select((floatv)(-INFINITY), value, s->is_active[v]));
        }
        float lows[RSH_WIDTH], highs[RSH_WIDTH];
        store_lanes(low, lows);
        store_lanes(high, highs);
        for (uint k = 0; k < RSH_WIDTH; ++k) {
            e.low[f] = fmin(e.low[f], lows[k]);
            e.high[f] = fmax(e.high[f], highs[k]);
        }
    }
    return e;
}

typedef struct rsh_fitted {
    float3 apex;
    float radius; /* negative: no active ray */
    float3 axis;
    float spread;
} rsh_fitted;

/* The middle of everything; nothing measured yet. */
static rsh_fitted guess(rsh_extent e)
{
    float middle[6];
    for (uint f = 0; f < 6; ++f) middle[f] = 0.5f * e.low[f] + 0.5f * e.high[f];
    rsh_fitted cone = {(float3)(middle[0], middle[1], middle[2]), -1.0f,
                       (float3)(middle[3], middle[4], middle[5]), 0.0f};
    if (!is_finite3(cone.apex)) cone.apex = (float3)(0.0f);
    const float length = safe_length(cone.axis);
    cone.axis = length > 0.1f && isfinite(length) ? cone.axis / length
                                                  : (float3)(0.0f, 0.0f, 1.0f);
    return cone;
}

/* Raises radius and spread to hold the rays. Cross and dot products of unit vectors that are
 * 16u off in length, 12u in angle: with their own 6u below 54u; the padding of `spread` is
 * 2^-18 = 64u. A length errs by 2^-20, a difference by u. */
static void measure(rsh_fitted* cone, const rsh_sheaf* s)
{
    floatv radius = (floatv)(-1.0f), spread = (floatv)(0.0f);
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const floatv wx = s->start[0][v] - cone->apex.x;
        const floatv wy = s->start[1][v] - cone->apex.y;
        const floatv wz = s->start[2][v] - cone->apex.z;
        const floatv scale = largest_of(wx, wy, wz);
        const floatv x = wx / scale, y = wy / scale, z = wz / scale;
        floatv away = scale * sqrt(x * x + y * y + z * z);
        away = select((floatv)(0.0f), away, scale > (floatv)(0.0f));
        away = select((floatv)(INFINITY), away, scale < (floatv)(INFINITY));
        away = away * (1.0f + 0x1p-18f) + s->more[v];

        const floatv dx = s->direction[0][v], dy = s->direction[1][v], dz = s->direction[2][v];
        const floatv nx = cone->axis.y * dz - cone->axis.z * dy;
        const floatv ny = cone->axis.z * dx - cone->axis.x * dz;
        const floatv nz = cone->axis.x * dy - cone->axis.y * dx;
        const floatv sine = sqrt(nx * nx + ny * ny + nz * nz);
        const floatv cosine = cone->axis.x * dx + cone->axis.y * dy + cone->axis.z * dz;
        const floatv wide = select((floatv)(2.0f) - sine, sine, cosine >= (floatv)(0.0f));
        radius = select(radius, fmax(radius, away), s->is_active[v]);
        spread = select(spread, fmax(spread, fmax(wide, s->spread[v])), s->is_active[v]);
    }
    float radii[RSH_WIDTH], spreads[RSH_WIDTH];
    store_lanes(radius, radii);
    store_lanes(spread, spreads);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        cone->radius = fmax(cone->radius, radii[k]);
        cone->spread = fmax(cone->spread, spreads[k]);
    }
}

/* Rounds what was measured outwards, away from 90 degrees; monotonic, so that the largest of
 * several rounded values is the rounded largest. sin 87 degrees = 0.9986, sin 120 = 0.866. */
static void round_outwards(rsh_fitted* cone)
{
    if (!(cone->radius >= 0.0f)) return;
    cone->radius = cone->radius * (1.0f + 0x1p-20f) + 0x1p-124f;
    cone->spread += 0x1p-18f;
    if (cone->spread > 0.9986f) cone->spread = fmax(cone->spread, 2.0f - 0.9986f);
    if (!(cone->spread < 2.0f - 0.866f) || !isfinite(cone->radius))
        cone->spread = RSH_ALL_DIRECTIONS;
}

static void store_fitted(__global float* group, uint lane, rsh_fitted cone)
{
    group[lane] = cone.apex.x;
    group[16 + lane] = cone.apex.y;
    group[32 + lane] = cone.apex.z;
    group[16 * RSH_RADIUS_ROW + lane] = cone.radius;
    group[64 + lane] = cone.axis.x;
    group[80 + lane] = cone.axis.y;
    group[96 + lane] = cone.axis.z;
    group[16 * RSH_SPREAD_ROW + lane] = cone.spread;
}

static __global float* group_at(__global float* groups, const rsh_levels* levels, uint level,
                                uint parent)
{
    return groups + 16ul * RSH_CONE_ROWS * (levels->first_quad[level] + parent);
}

/* The tile in its parent's group; the first child of a parent clears the lanes of those that do
 * not exist. */
static void store_tile(const rsh_levels* levels, uint tile, rsh_fitted cone,
                       __global float* groups)
{
    const rsh_place at = place_of(levels, 2, tile, 2);
    __global float* group = group_at(groups, levels, 2, at.parent);
    store_fitted(group, at.lane, cone);
    if (at.lane > 0) return;
    for (uint k = 1; k < 16; ++k)
        if (child_of(levels, 2, at.parent, k) == RSH_NO_NODE)
            store_fitted(group, k, guess(no_extent()));
}

/* A work-item fits the 16 blocks of its tile, and the tile, to their rays. */
__kernel void rsh_fit_tiles(rsh_levels shape, __global const rsh_ray* rays, uint is_converging,
                            __global float* groups)
{
    const uint me = get_global_id(0);
    if (me >= tile_count(shape)) return; /* launch is rounded up to whole groups */
    const rsh_levels levels = shape;
    const rsh_tile tile = tile_at(shape, 0, me);
    rsh_sheaf sheaf[16];
    rsh_extent whole = no_extent();
    for (uint b = 0; b < 16; ++b) {
        load_sheaf(&sheaf[b], tile, b, is_converging, rays);
        const rsh_extent extent = extent_of(&sheaf[b]);
        rsh_fitted cone = guess(extent);
        measure(&cone, &sheaf[b]);
        round_outwards(&cone);
        store_fitted(group_at(groups, &levels, 1, me), b, cone);
        add_extent(&whole, extent);
    }
    if (levels.count == 2) return; /* the tile is the root */
    rsh_fitted cone = guess(whole);
    for (uint b = 0; b < 16; ++b) measure(&cone, &sheaf[b]);
    round_outwards(&cone);
    store_tile(&levels, me, cone, groups);
}

/* Guesses the nodes of a level from their children; a work-item does a group of them. */
__kernel void rsh_guess_level(rsh_levels shape, uint level, __global float* groups)
{
    const rsh_levels levels = shape;
    const uint me = get_global_id(0);
    if (me >= levels.width[level + 1] * levels.height[level + 1]) return;
    for (uint k = 0; k < 16; ++k) {
        rsh_extent e = no_extent();
        const uint node = child_of(&levels, level, me, k);
        __global const float* in =
            group_at(groups, &levels, level - 1, node == RSH_NO_NODE ? 0 : node);
        for (uint c = 0; c < 16 && node != RSH_NO_NODE; ++c) {
            const float radius = in[16 * RSH_RADIUS_ROW + c];
            if (!(radius >= 0.0f)) continue;
            for (uint axis = 0; axis < 3; ++axis) {
                e.low[axis] = fmin(e.low[axis], in[16 * axis + c] - radius);
                e.high[axis] = fmax(e.high[axis], in[16 * axis + c] + radius);
                e.low[3 + axis] = fmin(e.low[3 + axis], in[16 * (4 + axis) + c]);
                e.high[3 + axis] = fmax(e.high[3 + axis], in[16 * (4 + axis) + c]);
            }
        }
        store_fitted(group_at(groups, &levels, level, me), k, guess(e));
    }
}

/* Measures the nodes of a level; a work-item brings the rays of a tile. Floats that are not
 * negative compare like their bits, and -1 is below them: a maximum of integers, whatever the
 * order. */
__kernel void rsh_measure_level(rsh_levels shape, uint level, __global const rsh_ray* rays,
                                uint is_converging, __global float* groups)
{
    const uint me = get_global_id(0);
    if (me >= tile_count(shape)) return;
    const rsh_levels levels = shape;
    const rsh_tile tile = tile_at(shape, 0, me);
    const rsh_place at = place_of(&levels, 2, me, level);
    __global float* node = group_at(groups, &levels, level, at.parent) + at.lane;
    rsh_fitted cone = {(float3)(node[0], node[16], node[32]), -1.0f,
                       (float3)(node[64], node[80], node[96]), 0.0f};
    rsh_sheaf sheaf;
    for (uint b = 0; b < 16; ++b) {
        load_sheaf(&sheaf, tile, b, is_converging, rays);
        measure(&cone, &sheaf);
    }
    if (!(cone.radius >= 0.0f)) return;
    round_outwards(&cone);
    atomic_max((volatile __global int*)(node + 16 * RSH_RADIUS_ROW), as_int(cone.radius));
    atomic_max((volatile __global int*)(node + 16 * RSH_SPREAD_ROW), as_int(cone.spread));
}
