/* tile_layout.h - which rays a tile holds: 16 blocks of 16 rays. In a grid, a block is 4 x 4
 * rays and a tile 4 x 4 blocks; in a list, both are ranges. */
#ifndef RSH_RAYS_TILE_LAYOUT_H
#define RSH_RAYS_TILE_LAYOUT_H

#include "rays/types.h"

typedef struct ray_tile {
    uint width, height;         /* rays; list: height 0 */
    uint x, y;                  /* first ray; list: x */
    __global const uint* order; /* rays by place, see ray_levels; 0: places are rays */
} ray_tile;

static uint tile_count(ray_levels shape) { return shape.width[2] * shape.height[2]; }

/* order: of a list; 0: as the rays lie. */
static ray_tile tile_at(ray_levels shape, __global const uint* order, uint tile)
{
    if (shape.is_list) return (ray_tile){shape.width[0], 0, 256 * tile, 0, order};
    const uint columns = shape.width[2];
    return (ray_tile){shape.width[0], shape.height[0], tile % columns * 16, tile / columns * 16,
                      0};
}

/* Index of a ray of the tile; RSH_NO_RAY outside of the grid or list. */
static uint ray_of(ray_tile tile, uint block, uint k)
{
    if (tile.height == 0) {
        const uint i = tile.x + 16 * block + k;
        if (i >= tile.width) return RSH_NO_RAY;
        return tile.order ? tile.order[i] : i;
    }
    const uint x = tile.x + 4 * (block & 3) + (k & 3), y = tile.y + (block & ~3u) + (k >> 2);
    return x < tile.width && y < tile.height ? y * tile.width + x : RSH_NO_RAY;
}

/* All sixteen rays of the block are there, four in a row each. */
static bool is_whole(ray_tile tile, uint block)
{
    return !tile.order && ray_of(tile, block, 15) != RSH_NO_RAY;
}

#endif
