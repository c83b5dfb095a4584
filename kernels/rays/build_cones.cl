/* build_cones.cl - the hierarchy over the rays, bottom-up: one launch per level, whose work-items
 * share the quads.
 *   rays        in   level 0
 *   list_count  in   how many rays of a list there are; NULL: all
 *   nodes       out  a head, then quads: nodes of all levels below the root; see cone_node4
 * "Choose loosely, measure exactly": axis and apex of a node are any good guess; radius and
 * sine are then measured from the guess as stored, rounded outwards, so that a node always
 * contains its rays. Does not test anything against the scene.
 */
#include "lanes/stride.h"
#include "mesh/algebra.h"
#include "rays/levels.h"
#include "rays/nodes_head.h"

typedef struct cone_node {
    float3 apex;
    float radius; /* negative: no active ray */
    float3 axis;
    float sine; /* 2: every direction */
} cone_node;

#define RSH_NO_CONE ((cone_node){(float3)(0.0f), -1.0f, (float3)(0.0f, 0.0f, 1.0f), 0.0f})
#define RSH_WHOLE_SPACE \
    ((cone_node){(float3)(0.0f), INFINITY, (float3)(0.0f, 0.0f, 1.0f), 2.0f})

/* Normalising errs by at most 12u in angle (u = 2^-24), also where divisions err by 2.5 ulp: a
 * cone of sine 2^-20 = 16u around the stored axis holds the true direction. */
#define RSH_LEAF_SINE 0x1p-20f

static cone_node ray_cone(rsh_ray ray)
{
    if (!is_active(ray)) return RSH_NO_CONE;
    const float3 d = ray.direction_tmax.xyz;
    const float scale = fmax(fabs(d.x), fmax(fabs(d.y), fabs(d.z)));
    const float3 scaled = d / scale;
    const float3 axis =
        scaled / sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
    /* A denormal direction may lose its bits to the division: then it could point anywhere. */
    const bool is_exact = scale >= 0x1p-100f;
    return (cone_node){ray.origin_tmin.xyz, 0.0f, axis, is_exact ? RSH_LEAF_SINE : 2.0f};
}

/* The same ray seen from its point at t = 1, backwards: rays that run towards one point make
 * the thinnest cones there. Every point with t <= 1 lies that way; for other rays the cone is
 * everything. The radius makes up for the sum, which rounds by u per component, and for the
 * hits of mesh/intersect.h: those are off by 47u of their distance to the origin, which is the
 * direction's length more than the distance to the apex that rays/cone_sphere.h allows for. */
static cone_node reversed_cone(rsh_ray ray)
{
    cone_node cone = ray_cone(ray);
    if (cone.radius < 0.0f) return cone;
    const float3 end = ray.origin_tmin.xyz + ray.direction_tmax.xyz;
    if (!(ray.direction_tmax.w <= 1.0f) || !is_finite3(end)) cone.sine = 2.0f;
    if (cone.sine > 1.0f) return cone;
    cone.radius = 0x1p-22f * (fabs(end.x) + fabs(end.y) + fabs(end.z)) +
                  0x1p-18f * safe_length(ray.direction_tmax.xyz) + 0x1p-124f;
    cone.apex = end;
    cone.axis = -cone.axis;
    return cone;
}

static cone_node quad_member(const cone_node4* quad, uint k)
{
    const float* f = (const float*)quad;
    return (cone_node){(float3)(f[k], f[4 + k], f[8 + k]), f[12 + k],
                       (float3)(f[16 + k], f[20 + k], f[24 + k]), f[28 + k]};
}

static void set_quad_member(cone_node4* quad, uint k, cone_node cone)
{
    float* f = (float*)quad;
    f[k] = cone.apex.x;
    f[4 + k] = cone.apex.y;
    f[8 + k] = cone.apex.z;
    f[12 + k] = cone.radius;
    f[16 + k] = cone.axis.x;
    f[20 + k] = cone.axis.y;
    f[24 + k] = cone.axis.z;
    f[28 + k] = cone.sine;
}

static float3 middle_of_apexes(const cone_node* child)
{
    float3 low = (float3)(INFINITY), high = (float3)(-INFINITY);
    for (int k = 0; k < 4; ++k)
        if (child[k].radius >= 0.0f) {
            low = fmin(low, child[k].apex - child[k].radius);
            high = fmax(high, child[k].apex + child[k].radius);
        }
    return 0.5f * low + 0.5f * high;
}

/* |apex - centre| errs by u in the difference and 2^-20 in the length, the sum by u. */
static float cone_radius(const cone_node* child, float3 centre)
{
    float radius = 0.0f;
    for (int k = 0; k < 4; ++k)
        if (child[k].radius >= 0.0f)
            radius = fmax(radius, safe_length(child[k].apex - centre) * (1.0f + 0x1p-18f) +
                                      child[k].radius);
    return radius * (1.0f + 0x1p-20f) + 0x1p-124f;
}

/* Sine of the widest angle between `axis` and a ray of a child: sin(theta + alpha), where theta
 * is the angle between the axes and alpha the child's half-angle. Cross and dot products of
 * unit vectors that are 16u off in length, products and sums, and cos alpha = sqrt(1 - sin^2)
 * with cos alpha >= 0.05 (error u / 0.1): together below 48u; the padding is 2^-18 = 64u. From
 * 87 degrees on, the cone counts as the whole space. */
static float cone_sine(const cone_node* child, float3 axis)
{
    float widest = 0.0f;
    for (int k = 0; k < 4; ++k) {
        if (!(child[k].radius >= 0.0f)) continue;
        const float3 n = cross3(child[k].axis, axis);
        const float sin_theta = sqrt(dot3(n, n));
        const float cos_theta = dot3(child[k].axis, axis);
        const float sin_alpha = child[k].sine;
        const float cos_alpha = sqrt(fmax(0.0f, 1.0f - sin_alpha * sin_alpha));
        if (!(cos_theta * cos_alpha - sin_theta * sin_alpha > 0.05f) || sin_alpha > 1.0f)
            return 2.0f;
        widest = fmax(widest, sin_theta * cos_alpha + cos_theta * sin_alpha);
    }
    return widest + 0x1p-18f;
}

/* The parent of four siblings; a single active child is copied bit for bit. */
static cone_node merge(const cone_node4* quad)
{
    cone_node child[4];
    uint active = 0;
    cone_node last = RSH_NO_CONE;
    float3 sum = (float3)(0.0f);
    for (int k = 0; k < 4; ++k) {
        child[k] = quad_member(quad, k);
        if (!(child[k].radius >= 0.0f)) continue;
        ++active;
        last = child[k];
        sum += child[k].axis;
    }
    if (active < 2) return last;

    cone_node parent;
    parent.apex = middle_of_apexes(child);
    parent.radius = cone_radius(child, parent.apex);
    if (!is_finite3(parent.apex) || !isfinite(parent.radius)) return RSH_WHOLE_SPACE;
    const float length_of_sum = safe_length(sum);
    parent.axis = length_of_sum > 0.1f ? sum / length_of_sum : last.axis;
    parent.sine = cone_sine(child, parent.axis);
    return parent;
}

static cone_node leaf(const ray_levels* levels, __global const rsh_ray* rays,
                      uint is_converging, uint parent, uint k)
{
    const uint child = child_of(levels, 0, parent, k);
    if (child == RSH_NO_NODE) return RSH_NO_CONE;
    const rsh_ray ray = rays[child];
    return is_converging ? reversed_cone(ray) : ray_cone(ray);
}

static __global cone_node4* quads_in(__global uint* nodes)
{
    return (__global cone_node4*)(nodes + RSH_NODES_HEAD_WORDS);
}

__kernel void rsh_build_cones_rays(ray_levels shape, __global const uint* list_count,
                                   __global const rsh_ray* rays, uint is_converging,
                                   __global uint* nodes)
{
    const ray_levels levels = counted_levels(shape, list_count);
    if (get_global_id(0) == 0)
        write_nodes_head(shape, levels.width[0], RSH_CONES_MADE, 0, nodes);
    const strided_range mine = my_elements(levels.width[1] * levels.height[1]);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        cone_node4 quad;
        for (uint k = 0; k < 4; ++k)
            set_quad_member(&quad, k, leaf(&levels, rays, is_converging, i, k));
        quads_in(nodes)[levels.first_child_group[0] + i] = quad;
    }
}

/* Child of a node of level + 1. */
static cone_node inner_node(const ray_levels* levels, uint level, uint parent, uint k,
                            __global const cone_node4* quads)
{
    const uint child = child_of(levels, level, parent, k);
    if (child == RSH_NO_NODE) return RSH_NO_CONE;
    const cone_node4 children = quads[levels->first_child_group[level - 1] + child];
    return merge(&children);
}

__kernel void rsh_build_cones_level(ray_levels shape, __global const uint* list_count,
                                    uint level, __global uint* nodes)
{
    __global cone_node4* quads = quads_in(nodes);
    const ray_levels levels = counted_levels(shape, list_count);
    const strided_range mine = my_elements(levels.width[level + 1] * levels.height[level + 1]);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        cone_node4 quad;
        for (uint k = 0; k < 4; ++k)
            set_quad_member(&quad, k, inner_node(&levels, level, i, k, quads));
        quads[levels.first_child_group[level] + i] = quad;
    }
}
