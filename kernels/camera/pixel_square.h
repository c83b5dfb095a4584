/* pixel_square.h - the square of pixels that one work-item owns: their rays, sheared once, and
 * their closest hits so far. Its pixels come in vectors: RSH_LANES_X x RSH_LANES_Y of them, a
 * lane each.
 *
 * SIMT devices (RSH_WIDTH 1): a pixel per work-item, a tile per work-group. Elsewhere a
 * work-item owns the whole tile. Knows nothing of lists: triangles must be offered in ascending
 * order.
 */
#ifndef RSH_CAMERA_PIXEL_SQUARE_H
#define RSH_CAMERA_PIXEL_SQUARE_H

#include "camera/types.h"
#include "mesh/intersect.h"

#ifndef RSH_TILE
#define RSH_TILE 16 /* pixels along a tile's edge */
#endif
#define RSH_SIDE (RSH_WIDTH == 1 ? 1 : RSH_TILE) /* ... along a work-item's square */
#define RSH_LANES_X (RSH_WIDTH >= 8 ? 4 : RSH_WIDTH >= 4 ? 2 : 1)
#define RSH_LANES_Y (RSH_WIDTH / RSH_LANES_X)
#define RSH_COLUMNS (RSH_SIDE / RSH_LANES_X) /* of vectors in the square */
#define RSH_ROWS (RSH_SIDE / RSH_LANES_Y)

typedef struct pixel_lanes {
    sheared_rays rays;
    closest_hits best;
} pixel_lanes;

typedef struct pixel_square {
    int x, y; /* its first pixel */
    pixel_lanes lanes[RSH_ROWS * RSH_COLUMNS];
} pixel_square;

/* The pixel of each lane, in the vector whose first pixel is (column, row). */
static void lane_pixels(uint column, uint row, uint* x, uint* y)
{
    for (uint i = 0; i < RSH_WIDTH; ++i) {
        x[i] = column + i % RSH_LANES_X;
        y[i] = row + i / RSH_LANES_X;
    }
}

/* Unit directions of the rays of pixels; see rsh_camera. (x + 0.5) / width * 2 - 1 is written
 * as one quotient of whole numbers, which rounds once. NaN, and an inactive ray, where forward,
 * right and up cancel. */
static void pixel_directions(const screen_setup* screen, const uint* x, const uint* y,
                             floatv* direction)
{
    float from_centre_x[RSH_WIDTH], from_centre_y[RSH_WIDTH];
    for (uint i = 0; i < RSH_WIDTH; ++i) {
        const uint in_picture_x = screen->first_x + x[i], in_picture_y = screen->first_y + y[i];
        from_centre_x[i] = (float)(2 * (int)in_picture_x + 1 - (int)screen->picture_width);
        from_centre_y[i] = (float)(2 * (int)in_picture_y + 1 - (int)screen->picture_height);
    }
    const floatv across = load_lanes(from_centre_x) / (floatv)(screen->picture_width);
    const floatv down = load_lanes(from_centre_y) / (floatv)(screen->picture_height);
    const floatv dx = screen->forward_far.x + across * screen->right.x + down * screen->down.x;
    const floatv dy = screen->forward_far.y + across * screen->right.y + down * screen->down.y;
    const floatv dz = screen->forward_far.z + across * screen->right.z + down * screen->down.z;
    const floatv length = sqrt(dx * dx + dy * dy + dz * dz);
    direction[0] = dx / length;
    direction[1] = dy / length;
    direction[2] = dz / length;
}

static void store_rays(const screen_setup* screen, const uint* x, const uint* y,
                       const floatv* direction, __global rsh_ray* rays)
{
    float lanes[3][RSH_WIDTH];
    for (int axis = 0; axis < 3; ++axis) store_lanes(direction[axis], lanes[axis]);
    for (uint i = 0; i < RSH_WIDTH; ++i) {
        if (x[i] >= screen->width || y[i] >= screen->height) continue;
        const rsh_ray ray = {screen->eye_near, (float4)(lanes[0][i], lanes[1][i], lanes[2][i],
                                                        screen->forward_far.w)};
        rays[y[i] * screen->width + x[i]] = ray;
    }
}

static void begin_lanes(const screen_setup* screen, const uint* x, const uint* y,
                        pixel_lanes* lanes, __global rsh_ray* rays)
{
    floatv direction[3];
    pixel_directions(screen, x, y, direction);
    store_rays(screen, x, y, direction, rays);
    lanes->rays =
        shear_rays((floatv)(screen->eye_near.x), (floatv)(screen->eye_near.y),
                   (floatv)(screen->eye_near.z), direction[0], direction[1], direction[2],
                   (floatv)(screen->eye_near.w), (floatv)(screen->forward_far.w));
    lanes->best = no_hits();
}

RSH_CALLED static void begin_square(const screen_setup* screen, pixel_square* square,
                                    __global rsh_ray* rays)
{
    uint x[RSH_WIDTH], y[RSH_WIDTH];
    for (uint b = 0; b < RSH_ROWS * RSH_COLUMNS; ++b) {
        lane_pixels(square->x + b % RSH_COLUMNS * RSH_LANES_X,
                    square->y + b / RSH_COLUMNS * RSH_LANES_Y, x, y);
        begin_lanes(screen, x, y, &square->lanes[b], rays);
    }
}

/* First and last column and row of vectors, in .xy and .zw, that a box of pixels meets. */
static int4 lanes_met(const pixel_square* square, ushort4 box)
{
    const int4 pixels = convert_int4(box) - (int4)(square->x, square->y, square->x, square->y);
    return (int4)(max(pixels.x, 0) / RSH_LANES_X, max(pixels.y, 0) / RSH_LANES_Y,
                  min(pixels.z, RSH_SIDE - 1) / RSH_LANES_X,
                  min(pixels.w, RSH_SIDE - 1) / RSH_LANES_Y);
}

static bool meets_square(const pixel_square* square, ushort4 box)
{
    const int4 pixels = convert_int4(box);
    return pixels.x <= pixels.z && pixels.x < square->x + RSH_SIDE && pixels.z >= square->x &&
           pixels.y < square->y + RSH_SIDE && pixels.w >= square->y;
}

RSH_CALLED static void store_square(const screen_setup* screen, const pixel_square* square,
                                    __global rsh_hit* hits)
{
    uint x[RSH_WIDTH], y[RSH_WIDTH], primitive[RSH_WIDTH];
    float t[RSH_WIDTH], u[RSH_WIDTH], v[RSH_WIDTH];
    for (uint b = 0; b < RSH_ROWS * RSH_COLUMNS; ++b) {
        const pixel_lanes* lanes = &square->lanes[b];
        lane_pixels(square->x + b % RSH_COLUMNS * RSH_LANES_X,
                    square->y + b / RSH_COLUMNS * RSH_LANES_Y, x, y);
        store_lanes(lanes->best.t, t);
        store_lanes(lanes->best.u, u);
        store_lanes(lanes->best.v, v);
        store_lanes(lanes->best.primitive, primitive);
        for (uint i = 0; i < RSH_WIDTH; ++i) {
            if (x[i] >= screen->width || y[i] >= screen->height) continue;
            const float far = primitive[i] == RSH_NO_HIT ? screen->forward_far.w : t[i];
            hits[y[i] * screen->width + x[i]] = (rsh_hit){far, u[i], v[i], primitive[i]};
        }
    }
}

#endif
