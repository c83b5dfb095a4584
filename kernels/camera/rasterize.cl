/* rasterize.cl - primary rays and their closest hits, in screen tiles, without atomics.
 *   vertices, indices  in       triangles
 *   boxes              scratch  per triangle, the pixels that can see it
 *   ends               scratch  per chunk and tile, where the tile's list ends
 *   lists              scratch  per chunk, the tiles' lists one after the other
 *   rays, hits         out      row by row
 *
 * Triangles are cut into chunks, runs of the index order; one work-item lists a chunk's
 * triangles by tile. A tile goes through the chunks in order, so it meets triangles in
 * ascending order and nothing depends on which work-item is first. A list that does not fit is
 * not written: its tile looks through the boxes of the whole chunk instead. Hits are
 * mesh/intersect.h's alone: the boxes only leave out work.
 */
#include "camera/project.h"
#include "camera/screen_tile.h"

#define RSH_UNLISTED 0x80000000u /* flag in `ends`: the list did not fit */

__kernel void rsh_rasterize_project(rsh_screen screen, rsh_mesh mesh,
                                    __global const float* vertices,
                                    __global const uint* indices, __global ushort4* boxes)
{
    const uint i = get_global_id(0);
    if (i >= mesh.triangle_count) return; /* launch is rounded up to whole groups */
    rsh_triangle triangle;
    const bool is_valid = load_triangle(mesh, vertices, indices, i, &triangle) &&
                          is_finite3(triangle.v0) && is_finite3(triangle.v1) &&
                          is_finite3(triangle.v2);
    boxes[i] = is_valid ? project(&screen, triangle) : (ushort4)(1, 1, 0, 0);
}

static uint chunk_end(const rsh_screen* screen, uint chunk)
{
    const uint begin = chunk * screen->chunk_length;
    return begin + min(screen->chunk_length, screen->triangle_count - begin);
}

/* Counts in `ends`, per tile, the triangles from `begin` to `end`. */
static void count_triangles(const rsh_screen* screen, __global const ushort4* boxes, uint begin,
                            uint end, __global uint* ends)
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
static void place_lists(const rsh_screen* screen, __global uint* ends)
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
static void fill_lists(const rsh_screen* screen, __global const ushort4* boxes, uint begin,
                       uint end, __global uint* ends, __global uint* list)
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

__kernel void rsh_rasterize_bin(rsh_screen screen, __global const ushort4* boxes,
                                __global uint* ends, __global uint* lists)
{
    const uint chunk = get_global_id(0);
    if (chunk >= screen.chunk_count) return; /* launch is rounded up to whole groups */
    const uint begin = chunk * screen.chunk_length, end = chunk_end(&screen, chunk);
    ends += (ulong)chunk * screen.tile_count;
    lists += (ulong)chunk * screen.capacity;
    count_triangles(&screen, boxes, begin, end, ends);
    place_lists(&screen, ends);
    fill_lists(&screen, boxes, begin, end, ends, lists);
}

typedef struct rsh_input {
    rsh_mesh mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const ushort4* boxes;
} rsh_input;

static void offer(const rsh_input* input, rsh_square* square, uint i)
{
    const ushort4 box = input->boxes[i];
    rsh_triangle triangle;
    if (!meets_square(square, box) ||
        !load_triangle(input->mesh, input->vertices, input->indices, i, &triangle))
        return;
    floatv corner[9];
    spread_triangle(triangle, corner);
    const int4 range = blocks_in(square, box);
    for (int y = range.y; y <= range.w; ++y)
        for (int x = range.x; x <= range.z; ++x) {
            rsh_block* block = &square->blocks[y * RSH_COLUMNS + x];
            keep_closer(&block->best, intersect(block->rays, corner), i);
        }
}

__kernel void rsh_rasterize_tiles(rsh_screen screen, rsh_mesh mesh,
                                  __global const float* vertices, __global const uint* indices,
                                  __global const ushort4* boxes, __global const uint* ends,
                                  __global const uint* lists, __global rsh_ray* rays,
                                  __global rsh_hit* hits)
{
    const rsh_input input = {mesh, vertices, indices, boxes};
    const uint tile = get_group_id(0), item = get_local_id(0);
    rsh_square square;
    square.x = tile % screen.tile_columns * RSH_TILE + item % (RSH_TILE / RSH_SIDE) * RSH_SIDE;
    square.y = tile / screen.tile_columns * RSH_TILE + item / (RSH_TILE / RSH_SIDE) * RSH_SIDE;
    begin_square(&screen, &square, rays);
    for (uint chunk = 0; chunk < screen.chunk_count; ++chunk) {
        __global const uint* list_end = ends + (ulong)chunk * screen.tile_count + tile;
        __global const uint* list = lists + (ulong)chunk * screen.capacity;
        if (*list_end & RSH_UNLISTED) {
            const uint end = chunk_end(&screen, chunk);
            for (uint i = chunk * screen.chunk_length; i < end; ++i) offer(&input, &square, i);
        } else {
            const uint begin = tile == 0 ? 0 : list_end[-1] & ~RSH_UNLISTED;
            for (uint i = begin; i < *list_end; ++i) offer(&input, &square, list[i]);
        }
    }
    store_square(&screen, &square, hits);
}
