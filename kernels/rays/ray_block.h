/* ray_block.h - the sixteen rays of a block, component by component: loaded and transposed. */
#ifndef RSH_RAYS_RAY_BLOCK_H
#define RSH_RAYS_RAY_BLOCK_H

#include "lanes/sixteen.h"
#include "mesh/triangles.h"
#include "rays/tile_layout.h"
#include "tuning.h"

/* The rows of rsh_ray: origin x y z, tmin, direction x y z, tmax. */
enum { RSH_TMIN = 3, RSH_DIRECTION = 4, RSH_TMAX = 7, RSH_RAY_ROWS = 8 };

typedef struct ray_block {
    floatv row[RSH_RAY_ROWS][RSH_VECTORS];
    intv is_active[RSH_VECTORS]; /* mask; see rsh_ray */
} ray_block;

/* The same bits as is_active of mesh/triangles.h. */
static intv are_active(const ray_block* block, uint v)
{
    const floatv infinite = (floatv)(INFINITY), zero = (floatv)(0.0f);
    intv is_finite = block->row[RSH_TMIN][v] <= block->row[RSH_TMAX][v];
    intv has_direction = block->row[RSH_DIRECTION][v] != zero;
    for (uint axis = 0; axis < 3; ++axis) {
        const floatv d = block->row[RSH_DIRECTION + axis][v];
        is_finite &= (fabs(block->row[axis][v]) < infinite) & (fabs(d) < infinite);
        has_direction |= d != zero;
    }
    return is_finite & has_direction;
}

static uint active_lanes(const ray_block* block)
{
    uint bits = 0;
    for_each_vector(v) bits |= RSH_LANE_BITS(block->is_active[v]) << (RSH_WIDTH * v);
    return bits;
}

#if RSH_WIDTH > 1
/* Asks for a block of four times four rays in a row, two to a cache line. */
static void expect_whole_block(ray_tile tile, uint b, __global const rsh_ray* rays)
{
    for (uint r = 0; r < 4; ++r) {
        const uint i = ray_of(tile, b, 4 * r);
        if (i == RSH_NO_RAY) continue;
        RSH_EXPECT_LOAD(rays + i);
        RSH_EXPECT_LOAD(rays + i + 2);
    }
}

/* Four times four rays in a row; asks for the tile's next block. */
static void load_whole_block(ray_tile tile, uint b, __global const rsh_ray* rays,
                             ray_block* block)
{
    __global const float* four[4];
    for (uint r = 0; r < 4; ++r)
        four[r] = (__global const float*)(rays + ray_of(tile, b, 4 * r));
    expect_whole_block(tile, (b + 1) % 16, rays);
#pragma unroll
    for (uint end = 0; end < 2; ++end) { /* of a ray: its origin, its direction */
        float16 row[4];
#pragma unroll
        for (uint i = 0; i < 4; ++i)
            row[i] = (float16)(vload4(2 * i + end, four[0]), vload4(2 * i + end, four[1]),
                               vload4(2 * i + end, four[2]), vload4(2 * i + end, four[3]));
        transpose_fours(row);
#pragma unroll
        for (uint i = 0; i < 4; ++i) take_apart(row[i], block->row[RSH_DIRECTION * end + i]);
    }
}
#endif

/* In the order of a sorted list, a ray's memory is nowhere near that of the one before: asks for a ray
 * some places ahead, of this tile or the next. */
static void expect_ray(ray_tile tile, uint place, __global const rsh_ray* rays)
{
    const uint i = tile.x + place + RSH_RAYS_AHEAD;
    if (tile.order && i < tile.width) RSH_EXPECT_LOAD(rays + tile.order[i]);
}

static void load_part_of_block(ray_tile tile, uint b, __global const rsh_ray* rays,
                               ray_block* block)
{
    float lane[RSH_RAY_ROWS][16];
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(tile, b, k);
        expect_ray(tile, 16 * b + k, rays);
        float8 row = (float8)(0.0f);
        if (i != RSH_NO_RAY) row = vload8(0, (__global const float*)(rays + i));
        float values[RSH_RAY_ROWS];
        vstore8(row, 0, values);
        for (uint f = 0; f < RSH_RAY_ROWS; ++f) lane[f][k] = values[f];
    }
    for (uint f = 0; f < RSH_RAY_ROWS; ++f)
        for_each_vector(v) block->row[f][v] = load_lanes(lane[f] + RSH_WIDTH * v);
}

/* Lanes outside of the grid or list are inactive. */
static void load_block(ray_tile tile, uint b, __global const rsh_ray* rays, ray_block* block)
{
#if RSH_WIDTH > 1
    if (is_whole(tile, b))
        load_whole_block(tile, b, rays, block);
    else
#endif
        load_part_of_block(tile, b, rays, block);
    for_each_vector(v) block->is_active[v] = are_active(block, v);
}

#endif
