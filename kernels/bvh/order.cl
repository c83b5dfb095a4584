/* order.cl - keys for the order in which triangles make clusters: along Hilbert's
 * curve, the few that are large against the scene first, lest every box that holds one of them
 * among small ones becomes large.
 *   vertices, indices  in   triangles
 *   sorting, keys      out  for order/sort.cl, and how many triangles are in each of its bins, cells
 *   is_update, now,    in   1: the order that `boxes` hold stays if it serves (bvh/refit_quality.h);
 *   boxes                   else they are no bounds any more
 * Where runs of 16 triangles are compact as they come, as in most meshes, they stay in their
 * order within a cell. Where they are not, each cell is sorted on. The device decides. A
 * work-item has a run of the triangles.
 */
#include "bvh/refit_quality.h"
#include "order/hilbert.h"
#include "order/sort.h"

/* Longest side of a large triangle's box, of that of the scene. */
#define RSH_LARGE 0.125f

/* Bits of a cell's side where cells are sorted on. */
#define RSH_FINE_BITS 7

/* Neighbours on a surface share their boxes' surface; strangers span the space between them. Of
 * runs of 16, a sixth is above this in meshes of grids, a third and more in what was modelled
 * part by part. */
#define RSH_SPARSE 1.5f

static void ask_group(const rsh_boxes* boxes, rsh_span* span)
{
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    add_boxes(boxes, low, high);
    for (uint axis = 0; axis < 3; ++axis) {
        span->low[axis] = fmin(span->low[axis], low[axis]);
        span->high[axis] = fmax(span->high[axis], high[axis]);
    }
    ++span->asked;
    span->sparse += surface_of(low, high) > RSH_SPARSE * surface_of_boxes(boxes);
}

/* Looks at the order that `boxes` hold; if `is_record`, only at one that was made just now. */
__kernel void rsh_order_survey(rsh_mesh mesh, __global const float* vertices,
                               __global const uint* indices, rsh_scene_shape shape,
                               uint is_record, __global const rsh_sorting* sorting,
                               __global const float* boxes, __global float* surveys,
                               ulong first)
{
    const uint me = get_global_id(0);
    if (me >= RSH_SURVEYS) return; /* launch is rounded up to whole groups */
    if (is_record ? !sorting->is_needed : !are_made_of(boxes, shape)) return;
    __global const uint* order = (__global const uint*)boxes + RSH_ORDER_AT(shape);
    ((__global rsh_survey*)(surveys + first))[me] =
        survey_at(me, mesh, vertices, indices, order, (shape.triangles + 15) / 16);
}

static bool keeps_order(uint is_update, __global const rsh_survey* now,
                        __global const float* boxes, rsh_scene_shape shape)
{
    return is_update && are_made_of(boxes, shape) &&
           order_serves(now, (__global const rsh_survey*)(boxes + RSH_SURVEYS_AT(shape)));
}

/* Decides whether there is a new order, for all that follows. */
__kernel void rsh_order_measure(rsh_mesh mesh, __global const float* vertices,
                                __global const uint* indices, rsh_scene_shape shape,
                                uint is_update, __global const rsh_survey* now,
                                __global const float* boxes, __global rsh_span* spans,
                                __global rsh_sorting* sorting)
{
    const bool is_kept = keeps_order(is_update, now, boxes, shape);
    if (get_global_id(0) == 0) *sorting = (rsh_sorting){!is_kept, 0};
    if (is_kept) return;
    const rsh_part mine = my_groups(mesh.triangle_count);
    rsh_span span = no_span();
    for (uint g = mine.begin; g < mine.end; g += asking_step(mine)) {
        rsh_corner_rows corners;
        rsh_boxes boxes;
        load_corners(mesh, vertices, indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
        ask_group(&boxes, &span);
    }
    spans[get_global_id(0)] = span;
}

/* How triangles get their keys: cell * 2^rest + place in the cell. */
typedef struct rsh_grid {
    float low[3], scale, large;
    uint bits;      /* of a coordinate */
    uint cell_bits; /* those that make the cell */
    uint rest;
} rsh_grid;

/* Some runs always are: those that end one object and begin the next. */
static bool is_sparse(rsh_span span) { return span.sparse > span.asked / 4; }

static rsh_grid grid_of(__global const rsh_span* spans, uint cell_bits)
{
    const rsh_span whole = whole_span(spans, get_global_size(0));
    const float longest = longest_side(&whole);
    rsh_grid grid;
    for (uint axis = 0; axis < 3; ++axis) grid.low[axis] = whole.low[axis];
    grid.bits = is_sparse(whole) ? RSH_FINE_BITS : cell_bits;
    grid.cell_bits = cell_bits;
    grid.rest = 3 * (grid.bits - cell_bits);
    grid.scale = cells_per_length(longest, grid.bits);
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
            cell[axis] =
                cell_of(0.5f * low + 0.5f * high, grid.low[axis], grid.scale, grid.bits);
            is_large |= high - low > (floatv)(grid.large);
        }
        const uintv place = hilbert_place(cell, grid.bits);
        store_lanes(select(place + (large_cells << grid.rest), place >> 6, as_uintv(is_large)),
                    keys + RSH_WIDTH * v);
    }
}

/* Keys of all triangles, and how many are in each cell. */
__kernel void rsh_order_keys(rsh_mesh mesh, __global const float* vertices,
                             __global const uint* indices, __global float* boxes,
                             uint cell_bits, __global const rsh_span* spans,
                             __global rsh_sorting* sorting, __global uint* keys,
                             __global uint* bins)
{
    if (!sorting->is_needed) return;
    const rsh_part mine = my_groups(mesh.triangle_count);
    const rsh_grid grid = grid_of(spans, cell_bits);
    if (get_global_id(0) == 0) {
        sorting->rest = grid.rest;
        bounds_head(boxes)->made = 0;
    }
    __global uint* own = bins + (ulong)RSH_ORDER_BINS(cell_bits) * get_global_id(0);
    for (uint b = 0; b < RSH_ORDER_BINS(cell_bits); ++b) own[b] = 0;
    for (uint g = mine.begin; g < mine.end; ++g) {
        rsh_corner_rows corners;
        rsh_boxes boxes;
        uint key[16];
        load_corners(mesh, vertices, indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
        keys_of_boxes(&boxes, grid, key);
        store_keys(key, g, mesh.triangle_count, grid.rest, keys, own);
    }
}
