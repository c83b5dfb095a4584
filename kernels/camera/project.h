/* project.h - which pixels can see a triangle? A box that misses none of them.
 *
 * Let mesh/intersect.h report a hit of a pixel's ray. Then, with the triangle's corners p_i and
 * weights l_i >= 0 of sum 1, the ray passes the point Y = sum l_i p_i at a distance of at most
 * sum l_i e_i, and its depth there is as much off. Per component (u = 2^-24, w_i = p_i - eye,
 * |.| its largest component):
 *    31u |w_i|   mesh/intersect.h, sideways and along the ray
 *     6u |w_i|   the coordinates below, as rounded: subtraction, products, sums, row entries
 *     7u |w_i|   crossing(), which weighs both ends with relative errors
 * so e_i = 2^-18 |w_i| has room to spare, and 2^-120 covers what a device flushes to zero.
 * Times the sum of a row's sizes, it bounds the error of that coordinate: E_depth, E_across.
 *
 * The ray itself looks along (1, x', y') with x' within across_padding of the pixel's x, at
 * most 2 in size (rasterize.cpp). From |across(Y) - x' depth| <= E_across + 2 E_depth = G
 * follows
 *   x in  [across(Y) - G, across(Y) + G] / depth(Y) -+ across_padding   where depth(Y) > 0.
 * The bounds are ratios of linear functions of Y, as e_i is weighed like p_i: over any part of
 * the triangle with depth > 0 they are extreme at the part's corners. The part that matters
 * begins at depth  nearest = near_depth - 2 max E_depth: twice, for the ray's t is as uncertain
 * as Y. Where
 * that is not safely positive, the triangle is cut at  cut = 4 max E_depth:
 *
 *     depth ^    \ screen /    front: divided by its depth
 *       cut +-----\------/---
 *         0 +------\-eye/----  slice: |across| <= 2 cut + G there if a ray sees it: then the
 *   nearest +-------------      eye is as good as inside, and the whole screen may see it
 *
 * What cannot be compared, or nearly overflows, is taken to cover the whole screen.
 */
#ifndef RSH_CAMERA_PROJECT_H
#define RSH_CAMERA_PROJECT_H

#include "camera/types.h"
#include "mesh/triangles.h"

/* A corner in camera coordinates. bounds: across and down, minus G in .xy, plus G in .zw. */
typedef struct projected_corner {
    float depth;
    float4 bounds;
} projected_corner;

/* Depths between which a part of the triangle lies, and the least depth to divide by. */
typedef struct depth_range {
    float nearest, farthest, divisor;
} depth_range;

static float row_times(float4 row, float3 w) { return row.x * w.x + row.y * w.y + row.z * w.z; }

static projected_corner corner_of(const screen_setup* screen, float3 position,
                                  float* depth_error)
{
    const float3 w = position - screen->eye_near.xyz;
    const float reach = 0x1p-18f * fmax(fabs(w.x), fmax(fabs(w.y), fabs(w.z))) + 0x1p-120f;
    const float across = row_times(screen->across_row, w);
    const float down = row_times(screen->down_row, w);
    *depth_error = screen->depth_row.w * reach;
    const float across_error = screen->across_row.w * reach + 2.0f * *depth_error;
    const float down_error = screen->down_row.w * reach + 2.0f * *depth_error;
    projected_corner corner;
    corner.depth = row_times(screen->depth_row, w);
    corner.bounds = (float4)(across - across_error, down - down_error, across + across_error,
                             down + down_error);
    return corner;
}

static bool is_moderate(projected_corner corner)
{
    return fabs(corner.depth) < 0x1p100f && all(fabs(corner.bounds) < 0x1p100f);
}

/* Both weights come from differences with `depth`: each has a small relative error. */
static projected_corner crossing(projected_corner p, projected_corner q, float depth)
{
    const float span = q.depth - p.depth;
    projected_corner corner;
    corner.depth = depth;
    corner.bounds =
        p.bounds * ((q.depth - depth) / span) + q.bounds * ((depth - p.depth) / span);
    return corner;
}

static float4 grow(float4 extent, projected_corner corner, depth_range range)
{
    const float4 bounds = corner.bounds / fmax(corner.depth, range.divisor);
    return (float4)(fmin(extent.xy, bounds.xy), fmax(extent.zw, bounds.zw));
}

static float4 grow_by_crossing(float4 extent, const projected_corner* ends, float depth,
                               depth_range range)
{
    if ((ends[0].depth < depth) == (ends[1].depth < depth)) return extent;
    return grow(extent, crossing(ends[0], ends[1], depth), range);
}

/* Box of the part's corners: those of the triangle that lie in it, and where edges enter it. */
static float4 extent_on_screen(const projected_corner* corners, depth_range range)
{
    float4 extent = (float4)(INFINITY, INFINITY, -INFINITY, -INFINITY);
    for (int i = 0; i < 3; ++i) {
        const projected_corner ends[2] = {corners[i], corners[i == 2 ? 0 : i + 1]};
        if (ends[0].depth >= range.nearest && ends[0].depth <= range.farthest)
            extent = grow(extent, ends[0], range);
        extent = grow_by_crossing(extent, ends, range.nearest, range);
        extent = grow_by_crossing(extent, ends, range.farthest, range);
    }
    return extent;
}

static bool is_around_eye(const projected_corner* corners, depth_range slice)
{
    const float4 extent = extent_on_screen(corners, slice);
    return all(extent.xy <= 2.0f) && all(extent.zw >= -2.0f);
}

/* First and last pixel of the window, in .xy and .zw; first > last: none. Pixel centres are at
 * (pixel + 0.5) / size * 2 - 1; the paddings have room for the 16u that rounding adds here. */
static ushort4 pixels_of(const screen_setup* screen, float4 extent)
{
    const float2 padding = (float2)(screen->across_padding, screen->down_padding);
    const float2 size = (float2)(screen->picture_width, screen->picture_height);
    const float2 begin = (float2)(screen->first_x, screen->first_y);
    const float2 end = begin + (float2)(screen->width, screen->height);
    const float2 low = (extent.xy - padding + 1.0f) * (0.5f * size) - 0.5f;
    const float2 high = (extent.zw + padding + 1.0f) * (0.5f * size) - 0.5f;
    const float2 first = fmin(fmax(ceil(low), begin), end) - begin;
    const float2 last = fmin(fmax(floor(high), begin - 1.0f), end - 1.0f) - begin;
    if (any(first > last)) return (ushort4)(1, 1, 0, 0);
    return (ushort4)(convert_ushort2(first), convert_ushort2(last));
}

static ushort4 whole_screen(const screen_setup* screen)
{
    return (ushort4)(0, 0, screen->width - 1, screen->height - 1);
}

static ushort4 project(const screen_setup* screen, triangle_points triangle)
{
    projected_corner corners[3];
    float error[3];
    corners[0] = corner_of(screen, triangle.v0, error + 0);
    corners[1] = corner_of(screen, triangle.v1, error + 1);
    corners[2] = corner_of(screen, triangle.v2, error + 2);
    if (!is_moderate(corners[0]) || !is_moderate(corners[1]) || !is_moderate(corners[2]))
        return whole_screen(screen);
    const float depth_error = fmax(error[0], fmax(error[1], error[2]));
    const float nearest = screen->near_depth - 2.0f * depth_error;
    const float cut = fmax(nearest, 4.0f * depth_error);
    const depth_range slice = {nearest, cut, cut}, front = {cut, INFINITY, cut};
    if (nearest < cut && is_around_eye(corners, slice)) return whole_screen(screen);
    return pixels_of(screen, extent_on_screen(corners, front));
}

#endif
