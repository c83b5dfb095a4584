/* rasterize.cl - primary rays and their closest hits, in screen tiles, without atomics.
 *   vertices, indices  in       triangles
 *   boxes              scratch  per triangle, the pixels that can see it
 *   ends               scratch  per range and tile, where the list of the tile ends
 *   lists              scratch  per range, the tiles' lists one after the other
 *   rays, hits         out      row by row
 *
 * Triangles are cut into ranges by their index; one work-item lists a range's triangles by
 * tile. A tile goes through the ranges in order, so it meets triangles in ascending order and
 * nothing depends on which work-item is first. A list that does not fit is not written: its
 * tile looks through the boxes of the whole range instead. Hits are mesh/intersect.h's alone:
 * the boxes only leave out work.
 */
#include "camera/pixel_square.h"
#include "camera/project.h"
#include "lanes/stride.h"

#define RSH_UNLISTED 0x80000000u /* flag in `ends`: the list did not fit */

/* Of triangle i; first > last: none. */
static ushort4 box_of(const screen_setup* screen, mesh_view mesh,
                      __global const float* vertices, __global const uint* indices, uint i)
{
    triangle_points triangle;
    const bool is_valid = load_triangle(mesh, vertices, indices, i, &triangle) &&
                          is_finite3(triangle.v0) && is_finite3(triangle.v1) &&
                          is_finite3(triangle.v2);
    return is_valid ? project(screen, triangle) : (ushort4)(1, 1, 0, 0);
}

RSH_CALLED static void project_triangles(const screen_setup* screen, mesh_view mesh,
                                         __global const float* vertices,
                                         __global const uint* indices, strided_range mine,
                                         __global ushort4* boxes)
{
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        boxes[i] = box_of(screen, mesh, vertices, indices, i);
}

__kernel void rsh_rasterize_project(screen_setup screen, mesh_view mesh,
                                    __global const float* vertices,
                                    __global const uint* indices, __global ushort4* boxes)
{
    project_triangles(&screen, mesh, vertices, indices, my_elements(mesh.triangle_count),
                      boxes);
}

static uint range_end(const screen_setup* screen, uint range)
{
    const uint begin = range * screen->range_length;
    return begin + min(screen->range_length, screen->triangle_count - begin);
}

/* Counts in `ends`, per tile, the triangles from `begin` to `end`. */
RSH_CALLED static void count_triangles(const screen_setup* screen,
                                       __global const ushort4* boxes, uint begin, uint end,
                                       __global uint* ends)
{
    for (uint i = 0; i < screen->tile_count; ++i) ends[i] = 0;
    for (uint i = begin; i < end; ++i) {
        const uint4 box = convert_uint4(boxes[i]);
        if (box.x > box.z) continue;
        for (uint y = box.y / RSH_TILE; y <= box.w / RSH_TILE; ++y)
            for (uint x = box.x / RSH_TILE; x <= box.z / RSH_TILE; ++x)
                ++ends[y * screen->tile_columns + x];
    }
}

/* Counts become the lists' beginnings; a list that does not fit takes no room. */
static void place_lists(const screen_setup* screen, __global uint* ends)
{
    uint used = 0;
    for (uint i = 0; i < screen->tile_count; ++i) {
        const uint count = ends[i];
        const bool fits = count <= screen->capacity - used;
        ends[i] = fits ? used : used | RSH_UNLISTED;
        if (fits) used += count;
    }
}

/* Each entry moves its list's beginning on, until it is the end. */
RSH_CALLED static void fill_lists(const screen_setup* screen, __global const ushort4* boxes,
                                  uint begin, uint end, __global uint* ends,
                                  __global uint* list)
{
    for (uint i = begin; i < end; ++i) {
        const uint4 box = convert_uint4(boxes[i]);
        if (box.x > box.z) continue;
        for (uint y = box.y / RSH_TILE; y <= box.w / RSH_TILE; ++y)
            for (uint x = box.x / RSH_TILE; x <= box.z / RSH_TILE; ++x) {
                __global uint* at = ends + y * screen->tile_columns + x;
                if (!(*at & RSH_UNLISTED)) list[(*at)++] = i;
            }
    }
}

__kernel void rsh_rasterize_bin(screen_setup screen, __global const ushort4* boxes,
                                __global uint* ends, __global uint* lists)
{
    const uint range = get_global_id(0);
    if (range >= screen.range_count) return; /* launch is rounded up to whole groups */
    const uint begin = range * screen.range_length, end = range_end(&screen, range);
    ends += (ulong)range * screen.tile_count;
    lists += (ulong)range * screen.capacity;
    count_triangles(&screen, boxes, begin, end, ends);
    place_lists(&screen, ends);
    fill_lists(&screen, boxes, begin, end, ends, lists);
}

typedef struct raster_input {
    mesh_view mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const ushort4* boxes;
} raster_input;

static void offer(const raster_input* input, pixel_square* square, uint i)
{
    const ushort4 box = input->boxes[i];
    triangle_points triangle;
    if (!meets_square(square, box) ||
        !load_triangle(input->mesh, input->vertices, input->indices, i, &triangle))
        return;
    const uint places = put_in_order(&triangle);
    floatv corner[9];
    broadcast_triangle(triangle, corner);
    const int4 met = lanes_met(square, box);
    for (int y = met.y; y <= met.w; ++y)
        for (int x = met.x; x <= met.z; ++x) {
            pixel_lanes* lanes = &square->lanes[y * RSH_COLUMNS + x];
            keep_closer(&lanes->best, intersect(lanes->rays, corner), i, places);
        }
}

/* Offers the square what its tile's lists hold. */
RSH_CALLED static void offer_lists(const screen_setup* screen, const raster_input* input,
                                   uint tile, __global const uint* ends,
                                   __global const uint* lists, pixel_square* square)
{
    for (uint range = 0; range < screen->range_count; ++range) {
        __global const uint* list_end = ends + (ulong)range * screen->tile_count + tile;
        __global const uint* list = lists + (ulong)range * screen->capacity;
        if (*list_end & RSH_UNLISTED) {
            const uint end = range_end(screen, range);
            for (uint i = range * screen->range_length; i < end; ++i) offer(input, square, i);
        } else {
            const uint begin = tile == 0 ? 0 : list_end[-1] & ~RSH_UNLISTED;
            for (uint i = begin; i < *list_end; ++i) offer(input, square, list[i]);
        }
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_rasterize_tiles(screen_setup screen, mesh_view mesh,
                                  __global const float* vertices, __global const uint* indices,
                                  __global const ushort4* boxes, __global const uint* ends,
                                  __global const uint* lists, __global rsh_ray* rays,
                                  __global rsh_hit* hits)
{
    const raster_input input = {mesh, vertices, indices, boxes};
    const uint tile = get_group_id(0), item = get_local_id(0);
    pixel_square square;
    square.x = tile % screen.tile_columns * RSH_TILE + item % (RSH_TILE / RSH_SIDE) * RSH_SIDE;
    square.y = tile / screen.tile_columns * RSH_TILE + item / (RSH_TILE / RSH_SIDE) * RSH_SIDE;
    begin_square(&screen, &square, rays);
    offer_lists(&screen, &input, tile, ends, lists, &square);
    store_square(&screen, &square, hits);
}
