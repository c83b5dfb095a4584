/* types.h - camera, screen and lists of one rasterization, shared by host and device.
 * Not API.
 *
 * A point p has the camera coordinates (depth, across, down) with
 *   p - eye = depth * forward + across * right + down * (-up),
 * so a ray looks along (1, x, y) with x and y from -1 to 1 on the screen. The rows are those of
 * the inverse matrix: a dot product with p - eye gives a coordinate. */
#ifndef RSH_CAMERA_TYPES_H
#define RSH_CAMERA_TYPES_H

#include "rsh/rsh_types.h"

typedef struct screen_setup {
    rsh_float4 eye_near;    /* xyz [world], w: tmin of the rays */
    rsh_float4 forward_far; /* xyz, w: tmax of the rays         */
    rsh_float4 right;       /* these three: scaled alike so that the largest component is */
    rsh_float4 down;        /* in 0.5 .. 1; w: 0                                          */
    rsh_float4 depth_row; /* xyz, w: sum of their sizes. NaN: the camera is flat or nearly so */
    rsh_float4
        across_row; /* and every triangle is taken to cover the screen                  */
    rsh_float4 down_row;
    rsh_float across_padding; /* how far rounding can turn a ray, in units of x and y */
    rsh_float down_padding;
    rsh_float near_depth; /* no ray has less depth at tmin */
    rsh_uint width;       /* pixels of the window */
    rsh_uint height;
    rsh_uint first_x; /* where in the picture it begins */
    rsh_uint first_y;
    rsh_uint picture_width; /* pixels that x and y from -1 to 1 span */
    rsh_uint picture_height;
    rsh_uint tile_columns;
    rsh_uint tile_count;
    rsh_uint range_count;  /* ranges of triangles, each with tile lists of its own */
    rsh_uint range_length; /* triangles in a range, fewer in the last one          */
    rsh_uint capacity;     /* entries in all lists of one range, below 2^31      */
    rsh_uint triangle_count;
    rsh_uint padding;
} screen_setup;
RSH_ASSERT_SIZE(screen_setup, 176);

#endif
