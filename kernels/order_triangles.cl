/* order_triangles.cl - the order in which triangles make clusters, remade every frame: along
 * Hilbert's curve, the few that are large against the scene first, lest every box that holds
 * one of them among small ones becomes large.
 *   vertices, indices  in   triangles
 *   boxes              out  their order; see scene_boxes.h
 * One counting sort by cells. Where runs of 16 triangles are compact as they come, as meshes
 * mostly are, that is all: in a cell they stay as they are. Where they are not, each cell is
 * sorted on: rsh_order_refine. The device decides. A work-item has a run of the triangles and
 * counts of its own.
 */
#include "bound_boxes.h"
#include "hilbert.h"

/* Longest side of a large triangle's box, of that of the scene. */
#define RSH_LARGE 0.125f

/* Bits of a cell's side where cells are sorted on. */
#define RSH_FINE_BITS 7

/* Neighbours on a surface share their boxes' surface; strangers span the space between them. Of
 * runs of 16, a sixth is above this in meshes of grids, a third and more in what was modelled
 * part by part. */
#define RSH_SPARSE 1.5f

/* Groups of 16 triangles that a work-item looks at before all are sorted; keys take what lies
 * outside of their span for its margin. */
#define RSH_ASKED 64

typedef struct rsh_part {
    uint begin, end;
} rsh_part;

/* Triangles in groups of 16, cut into runs. */
static rsh_part my_groups(uint count)
{
    const uint groups = (count + 15) / 16, items = get_global_size(0);
    const uint run = (groups + items - 1) / items;
    const uint begin = min(groups, run * (uint)get_global_id(0));
    return (rsh_part){begin, min(groups, begin + run)};
}

static float surface_of(const float* low, const float* high)
{
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x >= 0.0f ? x * y + y * z + z * x : 0.0f;
}

/* Of boxes that hold something, added up. */
static float surface_of_boxes(const rsh_boxes* boxes)
{
    float total = 0.0f;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        floatv side[3];
        for (uint axis = 0; axis < 3; ++axis)
            side[axis] = boxes->high[axis][v] - boxes->low[axis][v];
        const floatv surface = side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
        float lane[RSH_WIDTH];
        store_lanes(select((floatv)(0.0f), surface, side[0] >= (floatv)(0.0f)), lane);
        for (uint k = 0; k < RSH_WIDTH; ++k) total += lane[k];
    }
    return total;
}

static void ask_group(const rsh_boxes* boxes, rsh_scene_extent* extent)
{
    float low[3], high[3];
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = smallest_lane(boxes->low[axis]);
        high[axis] = largest_lane(boxes->high[axis]);
        extent->low[axis] = fmin(extent->low[axis], low[axis]);
        extent->high[axis] = fmax(extent->high[axis], high[axis]);
    }
    ++extent->asked;
    extent->sparse += surface_of(low, high) > RSH_SPARSE * surface_of_boxes(boxes);
}

__kernel void rsh_order_measure(rsh_mesh mesh, __global const float* vertices,
                                __global const uint* indices,
                                __global rsh_scene_extent* extents)
{
    const rsh_part mine = my_groups(mesh.triangle_count);
    rsh_scene_extent extent = {
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, 0};
    const uint step = 1 + (mine.end - mine.begin) / RSH_ASKED;
    for (uint g = mine.begin; g < mine.end; g += step) {
        rsh_corner_rows corners;
        rsh_boxes boxes;
        load_corners(mesh, vertices, indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
        ask_group(&boxes, &extent);
    }
    extents[get_global_id(0)] = extent;
}

/* How triangles get their keys: cell * 2^rest + place in the cell. */
typedef struct rsh_grid {
    float low[3], scale, large;
    uint bits; /* of a coordinate */
    uint cell_bits;
    uint rest; /* bits of a key that make the place in the cell; 0: not asked for */
} rsh_grid;

/* Some runs always are: those that end one object and begin the next. */
static bool is_sparse(rsh_scene_extent extent) { return extent.sparse > extent.asked / 4; }

static rsh_grid grid_of(__global const rsh_scene_extent* extents, uint items, uint cell_bits)
{
    rsh_scene_extent whole = extents[0];
    for (uint i = 1; i < items; ++i) {
        for (uint axis = 0; axis < 3; ++axis) {
            whole.low[axis] = fmin(whole.low[axis], extents[i].low[axis]);
            whole.high[axis] = fmax(whole.high[axis], extents[i].high[axis]);
        }
        whole.asked += extents[i].asked;
        whole.sparse += extents[i].sparse;
    }
    rsh_grid grid;
    float longest = 0.0f;
    for (uint axis = 0; axis < 3; ++axis) {
        grid.low[axis] = whole.low[axis];
        longest = fmax(longest, whole.high[axis] - whole.low[axis]);
    }
    grid.bits = is_sparse(whole) ? RSH_FINE_BITS : cell_bits;
    grid.cell_bits = cell_bits;
    grid.rest = 3 * (grid.bits - cell_bits);
    const float cells = (1u << grid.bits) - 1;
    grid.scale = longest > 0.0f && isfinite(longest) ? cells / longest : 0.0f;
    grid.large = RSH_LARGE * longest;
    return grid;
}

static void keys_of_boxes(const rsh_boxes* boxes, rsh_grid grid, uint* keys)
{
    const uint large_cells = 1u << (3 * grid.cell_bits - 6);
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        uintv cell[3];
        intv is_large = (intv)(0);
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv low = boxes->low[axis][v], high = boxes->high[axis][v];
            const floatv at = (0.5f * low + 0.5f * high - grid.low[axis]) * grid.scale;
            const floatv last = (floatv)((float)((1u << grid.bits) - 1));
            cell[axis] = as_uintv(convert_intv(greater(lesser(at, last), (floatv)(0.0f))));
            is_large |= high - low > (floatv)(grid.large);
        }
        const uintv place = hilbert_place(cell, grid.bits);
        store_lanes(select(place + (large_cells << grid.rest), place >> 6, as_uintv(is_large)),
                    keys + RSH_WIDTH * v);
    }
}

/* Keys of all triangles, and how many are in each cell. */
__kernel void rsh_order_keys(rsh_mesh mesh, __global const float* vertices,
                             __global const uint* indices, uint cell_bits,
                             __global const rsh_scene_extent* extents, __global uint* keys,
                             __global uint* bins)
{
    const rsh_part mine = my_groups(mesh.triangle_count);
    const rsh_grid grid = grid_of(extents, get_global_size(0), cell_bits);
    __global uint* own = bins + (ulong)RSH_ORDER_BINS(cell_bits) * get_global_id(0);
    for (uint b = 0; b < RSH_ORDER_BINS(cell_bits); ++b) own[b] = 0;
    for (uint g = mine.begin; g < mine.end; ++g) {
        rsh_corner_rows corners;
        rsh_boxes boxes;
        uint key[16];
        load_corners(mesh, vertices, indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
        keys_of_boxes(&boxes, grid, key);
        for (uint k = 0; k < 16 && 16 * g + k < mesh.triangle_count; ++k) {
            keys[16 * g + k] = key[k];
            ++own[key[k] >> grid.rest];
        }
    }
}

/* Counts to places: of all triangles in lower cells, and in this cell before this work-item. */
__kernel void rsh_order_scan(uint items, uint cell_bits, __global uint* bins)
{
    if (get_global_id(0) != 0) return;
    const uint count = RSH_ORDER_BINS(cell_bits);
    uint sum = 0;
    for (uint b = 0; b < count; ++b)
        for (uint i = 0; i < items; ++i) {
            __global uint* bin = bins + (ulong)count * i + b;
            const uint triangles = *bin;
            *bin = sum;
            sum += triangles;
        }
}

__kernel void rsh_order_scatter(rsh_box_levels shape, uint cell_bits,
                                __global const rsh_scene_extent* extents,
                                __global const uint* keys, __global uint* bins,
                                __global uint* boxes)
{
    const rsh_box_levels levels = shape;
    const rsh_part mine = my_groups(levels.boxes[0]);
    const rsh_grid grid = grid_of(extents, get_global_size(0), cell_bits);
    __global uint* own = bins + (ulong)RSH_ORDER_BINS(cell_bits) * get_global_id(0);
    __global uint* order = boxes + order_at(&levels);
    for (uint i = 16 * mine.begin; i < min(16 * mine.end, levels.boxes[0]); ++i)
        order[own[keys[i] >> grid.rest]++] = i;
}

#define RSH_PLACES 512 /* in a cell, at most */

/* Triangles of a cell by their places in it, as they come where these are equal. */
static void sort_cell(__global uint* order, uint count, __global const uint* keys, uint places,
                      __global uint* sorted)
{
    uint at[RSH_PLACES], sum = 0;
    for (uint p = 0; p < places; ++p) at[p] = 0;
    for (uint i = 0; i < count; ++i) ++at[keys[order[i]] & (places - 1)];
    for (uint p = 0; p < places; ++p) {
        const uint here = at[p];
        at[p] = sum;
        sum += here;
    }
    for (uint i = 0; i < count; ++i) sorted[at[keys[order[i]] & (places - 1)]++] = order[i];
    for (uint i = 0; i < count; ++i) order[i] = sorted[i];
}

/* A work-item takes a run of cells. bins: where the last work-item's triangles of a cell end,
 * after rsh_order_scatter. */
__kernel void rsh_order_refine(rsh_box_levels shape, uint items, uint cell_bits,
                               __global const rsh_scene_extent* extents,
                               __global const uint* keys, __global const uint* bins,
                               __global uint* sorted, __global uint* boxes)
{
    const rsh_box_levels levels = shape;
    const rsh_grid grid = grid_of(extents, items, cell_bits);
    if (grid.rest == 0) return;
    const uint cells = RSH_ORDER_BINS(cell_bits), count = get_global_size(0);
    const uint run = (cells + count - 1) / count, first = run * (uint)get_global_id(0);
    __global const uint* end = bins + (ulong)cells * (items - 1);
    __global uint* order = boxes + order_at(&levels);
    for (uint c = first; c < min(first + run, cells); ++c) {
        const uint begin = c ? end[c - 1] : 0;
        if (end[c] - begin > 16)
            sort_cell(order + begin, end[c] - begin, keys, 1u << grid.rest, sorted + begin);
    }
}
