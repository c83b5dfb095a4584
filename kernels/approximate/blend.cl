/* blend.cl - the pixels beside those of a grid: between corners that are alike, a pixel that looks like them
 * gets the mean of their colours. The others are listed.
 *   hits     in      of all pixels
 *   picture  in/out  colours of the grid's pixels, and of those that are not listed
 *   listed   out     RSH_BESIDES words for each of `places` (shade/screen_order.h): numbers of pixels,
 *                    RSH_NO_RAY: none; those of RSH_WIDTH places are together
 */
#include "approximate/types.h"
#include "lanes/stride.h"
#include "shade/screen_order.h"

typedef struct blend_buffers {
    surface_buffers scene; /* what material_of reads */
    __global const rsh_hit* hits;
    __global float4* picture;
} blend_buffers;

/* What rays see. Of a plane, `nearness`, the inverse of the distance, is nearly linear on the screen. */
typedef struct sight_lanes {
    floatv nearness;           /* 0: nothing is hit */
    uintv primitive, material; /* RSH_NO_HIT: likewise */
} sight_lanes;

/* Corners of RSH_WIDTH cells: here, to the right, below, across. */
typedef struct corner_lanes {
    floatv rgba[4][4]; /* a component of each corner, then the next component */
    sight_lanes sight[4];
} corner_lanes;

/* Of triangles. Where all are those of `known`, as in the middle of a large one, nothing is read. */
static uintv materials_of(const surface_buffers* scene, uintv primitive,
                          const sight_lanes* known)
{
    uint triangle[RSH_WIDTH], material[RSH_WIDTH];
    if (known && !any_lane(primitive != known->primitive)) return known->material;
    store_lanes(primitive, triangle);
    for (uint k = 0; k < RSH_WIDTH; ++k)
        material[k] = triangle[k] < scene->mesh.triangle_count ? material_of(scene, triangle[k])
                                                               : RSH_NO_HIT;
    return load_lanes(material);
}

/* index: all lanes can be loaded; known: what rays beside these see, or NULL. */
static sight_lanes load_sights(const blend_buffers* buffers, const uint* index,
                               const sight_lanes* known)
{
    floatv hit[4];
    load_rows4((__global const float*)buffers->hits, 4, index, hit);
    const uintv primitive = as_uintv(hit[3]);
    return (sight_lanes){(floatv)(1.0f) / hit[0], primitive,
                         materials_of(&buffers->scene, primitive, known)};
}

/* x, y: pixels where the cells in `whole` begin. */
RSH_CALLED static void load_corners(const blend_buffers* buffers, pixel_grid grid, uintv x,
                                    uintv y, uint whole, corner_lanes* at)
{
    for (uint n = 0; n < 4; ++n) {
        uint index[RSH_WIDTH];
        floatv rgba[4];
        const uintv right = x + grid.step * (n % 2), down = y + grid.step * (n / 2);
        fill_lanes(down * grid.width + right, whole, index);
        load_rows4((__global const float*)buffers->picture, 4, index, rgba);
        for (uint c = 0; c < 4; ++c) at->rgba[c][n] = rgba[c];
        at->sight[n] = load_sights(buffers, index, n ? at->sight : 0);
    }
}

/* Whether four values are equal but for the tolerance; not if one of them is NaN or infinite. */
static intv are_close(const floatv* value, float tolerance)
{
    const floatv low = fmin(fmin(value[0], value[1]), fmin(value[2], value[3]));
    const floatv high = fmax(fmax(value[0], value[1]), fmax(value[2], value[3]));
    const floatv none = (floatv)(0.0f) * (value[0] + value[1] + value[2] + value[3]);
    return (none == (floatv)(0.0f)) & (high - low <= (floatv)(tolerance));
}

/* A bit for each cell whose corners are. Square roots are about as far apart as colours look on a screen. */
static uint alike_lanes(const corner_lanes* at, float tolerance)
{
    intv alike = at->sight[0].material == at->sight[1].material;
    alike &= at->sight[0].material == at->sight[2].material;
    alike &= at->sight[0].material == at->sight[3].material;
    for (uint c = 0; c < 3; ++c) {
        floatv root[4];
        for (uint n = 0; n < 4; ++n) root[n] = sqrt(at->rgba[c][n]);
        alike &= are_close(root, tolerance);
    }
    return RSH_LANE_BITS(alike);
}

/* Between two corners, or all four. */
static floatv mean_of(const floatv* corner, uint dx, uint dy)
{
    const floatv half_way = (floatv)(0.5f);
    if (dy == 0) return half_way * (corner[0] + corner[1]);
    if (dx == 0) return half_way * (corner[0] + corner[2]);
    return half_way * (half_way * (corner[0] + corner[1]) + half_way * (corner[2] + corner[3]));
}

/* Of the cells in `alike`, those whose pixel `index` looks like their corners. It gets its colour. */
static uint blend_pixels(const blend_buffers* buffers, const corner_lanes* at, uint dx, uint dy,
                         const uint* index, uint alike, float tolerance)
{
    uint filled[RSH_WIDTH];
    floatv nearness[4], mean[4];
    if (alike == 0) return 0;
    fill_lanes(load_lanes(index), alike, filled);
    const sight_lanes seen = load_sights(buffers, filled, at->sight);
    for (uint n = 0; n < 4; ++n) nearness[n] = at->sight[n].nearness;
    const floatv off = seen.nearness - mean_of(nearness, dx, dy);
    const intv is_like = (seen.material == at->sight[0].material) &
                         (fabs(off) <= (floatv)(tolerance)*seen.nearness);
    for (uint c = 0; c < 4; ++c) mean[c] = mean_of(at->rgba[c], dx, dy);
    const uint blended = alike & RSH_LANE_BITS(is_like);
    store_rows4(mean, blended, (__global float*)buffers->picture, 4, index);
    return blended;
}

/* Cells of RSH_WIDTH places. */
typedef struct cell_lanes {
    uintv x, y; /* of the pixel where each begins; 0: outside of the screen */
    uint bits;  /* lane by lane: inside                                     */
} cell_lanes;

static cell_lanes find_cells(pixel_grid grid, wave_part places, uint first, uint end)
{
    uint number[RSH_WIDTH];
    number_lanes(first, end, number);
    const uintv place = load_lanes(number);
    const intv is_one = place != (uintv)(RSH_NO_RAY);
    cells at = {place, (uintv)(0u)};
    if (places.height > 1) at = cells_at_places(places, place, first);
    const intv is_inside =
        is_one & (at.x < (uintv)(grid.columns)) & (at.y < (uintv)(grid.rows));
    const uintv none = (uintv)(0u);
    return (cell_lanes){select(none, at.x * grid.step, is_inside),
                        select(none, at.y * grid.step, is_inside), RSH_LANE_BITS(is_inside)};
}

/* The cells whose corners are all on the screen and in one band. */
static uint whole_lanes(pixel_grid grid, const cell_lanes* cell)
{
    const uintv right = cell->x + grid.step, below = cell->y + grid.step;
    const intv is_whole = (right < (uintv)(grid.width)) & (below < (uintv)(grid.height)) &
                          (below % RSH_BAND_ROWS != (uintv)(0u));
    return cell->bits & RSH_LANE_BITS(is_whole);
}

/* To the words of `count` cells those pixels that are in `bits`. */
static void list_pixels(const uint* pixel, uint bits, uint count, __global uint* listed)
{
    uint word[RSH_WIDTH];
    const uintv all = select((uintv)(RSH_NO_RAY), load_lanes(pixel), mask_of_bits(bits));
    if (count == RSH_WIDTH) {
        store_whole_uint(__global, all, listed);
        return;
    }
    store_lanes(all, word);
    for (uint k = 0; k < count; ++k) listed[k] = word[k];
}

/* listed: the words of these cells, `count` of them or none from there on. */
RSH_CALLED static void blend_cells(const blend_buffers* buffers, pixel_grid grid,
                                   float tolerance, const cell_lanes* cell, uint count,
                                   __global uint* listed)
{
    corner_lanes at;
    const uint whole = whole_lanes(grid, cell);
    uint alike = 0;
    if (whole) {
        load_corners(buffers, grid, cell->x, cell->y, whole, &at);
        alike = whole & alike_lanes(&at, tolerance);
    }
    for (uint beside = 0; beside < RSH_BESIDES; ++beside) {
        uint pixel[RSH_WIDTH];
        const uint dx = (beside + 1) % 2, dy = (beside + 1) / 2;
        const uintv x = cell->x + grid.step / 2 * dx, y = cell->y + grid.step / 2 * dy;
        const intv is_inside = (x < (uintv)(grid.width)) & (y < (uintv)(grid.height));
        store_lanes(y * grid.width + x, pixel);
        const uint blended = blend_pixels(buffers, &at, dx, dy, pixel, alike, tolerance);
        const uint rest = cell->bits & RSH_LANE_BITS(is_inside) & ~blended;
        list_pixels(pixel, rest, count, listed + beside * count);
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_blend_pixels(mesh_view mesh, __global const uint* material_ids,
                               uint material_count, pixel_grid grid, wave_part places,
                               float tolerance, __global const rsh_hit* hits,
                               __global float4* picture, __global uint* listed)
{
    const blend_buffers buffers = {
        {mesh, 0, 0, 0, material_ids, material_count}, hits, picture};
    const strided_range mine = my_blocks(places.count);
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        const cell_lanes cell = find_cells(grid, places, i, mine.end);
        blend_cells(&buffers, grid, tolerance, &cell, min(mine.end - i, (uint)RSH_WIDTH),
                    listed + (ulong)RSH_BESIDES * i);
    }
}
