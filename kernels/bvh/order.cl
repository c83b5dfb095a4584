/* order.cl - keys for the order in which triangles become leaves: along Hilbert's curve, after
 * the few that are large beside the scene.
 *   vertices, indices  in      triangles of the tree
 *   sorting, keys      out     for order/sort.cl
 *   bins               out     how many triangles are in each bin, that is, in each cell
 *   wrong              out     RSH_WRONG_BOUNDS: a refit found no BVH, or not the still tree that
 *                              it is to keep
 *   bvh                in/out  with is_refit, its order stays if that still serves
 *                              (bvh/refit_quality.h); otherwise it is marked as not made
 *   now                in/out  how compact that order is now
 * Where ranges of 16 triangles are compact as they come, as in most meshes, triangles keep
 * their order within a cell; where they are not, each cell is sorted too. The device decides.
 * One kernel for all passes (order_pass in bvh/types.h): each loads triangles, most of what there
 * is to compile.
 */
#include "bvh/refit_quality.h"
#include "order/hilbert.h"
#include "order/sort.h"
#include "tuning.h"

/* What all passes look at, and what they leave for those that follow. */
typedef struct order_state {
    mesh_view mesh;
    __global const float* vertices;
    __global const uint* indices;
    bvh_layout layout;
    uint item, items; /* which work-item, of how many */
    __global float* bvh;
    __global sample_bounds* samples;
    __global sort_plan* sorting;
} order_state;

RSH_CALLED static void sample_triangles(const boxes16* boxes, sample_bounds* bounds)
{
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    add_boxes(boxes, low, high);
    for (uint axis = 0; axis < 3; ++axis) {
        bounds->low[axis] = fmin(bounds->low[axis], low[axis]);
        bounds->high[axis] = fmax(bounds->high[axis], high[axis]);
    }
    ++bounds->sampled;
    bounds->incoherent +=
        surface_of(low, high) > RSH_INCOHERENT_SURFACE * surface_of_boxes(boxes);
}

/* Measures one sample of the order that the BVH holds. */
RSH_CALLED static void measure_quality(const order_state* state,
                                       __global refit_quality* qualities)
{
    if (state->item >= RSH_QUALITY_SAMPLES) return; /* launch is rounded up to whole groups */
    __global const uint* order = (__global const uint*)state->bvh + RSH_ORDER_AT(state->layout);
    qualities[state->item] =
        quality_at(state->item, state->mesh, state->vertices, state->indices, order,
                   (state->layout.triangles + 15) / 16);
}

static bool keeps_order(uint is_refit, __global const refit_quality* now,
                        __global const float* bvh, bvh_layout layout)
{
    return is_refit && is_tree_made(bvh, layout.whole, layout.tree) &&
           order_serves(now, (__global const refit_quality*)(bvh + RSH_QUALITY_AT(layout)));
}

/* Whether the buffer holds what a refit keeps: the still tree, where there is one; otherwise
 * bounds, be they of other triangles. */
static bool can_refit(__global const float* bvh, bvh_layout layout)
{
    __global const uint* made = const_head_of(bvh)->made;
    return has_still(layout.whole)
               ? is_tree_made(bvh, layout.whole, RSH_STILL_TREE)
               : made[RSH_STILL_TREE] == RSH_BVH_MADE || made[RSH_MOVING_TREE] == RSH_BVH_MADE;
}

/* Decides, for all launches that follow, whether there will be a new order. A work-item has a range
 * of the triangles, here and for the keys. */
RSH_CALLED static void sample_range(const order_state* state, bool is_kept, range16 mine)
{
    if (state->item == 0)
        *state->sorting = (sort_plan){!is_kept, 0, state->mesh.triangle_count, state->items};
    if (is_kept) return;
    sample_bounds bounds = empty_bounds();
    for (uint g = mine.begin; g < mine.end; g += sampling_step(mine)) {
        corner_rows corners;
        boxes16 boxes;
        load_corners(state->mesh, state->vertices, state->indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
        sample_triangles(&boxes, &bounds);
    }
    state->samples[state->item] = bounds;
}

/* How triangles get their keys: cell << bin_shift | place along the curve within the cell. */
typedef struct key_grid {
    float low[3], scale, large;
    uint bits;      /* of a coordinate of the key */
    uint cell_bits; /* the upper ones of these, which make the cell */
    uint bin_shift;
} key_grid;

static bool triangles_are_incoherent(sample_bounds bounds)
{
    return bounds.incoherent > RSH_INCOHERENT_TRIANGLES(bounds.sampled);
}

static key_grid grid_of(__global const sample_bounds* samples, uint items, uint cell_bits)
{
    const sample_bounds whole = merged_bounds(samples, items);
    const float longest = longest_side(&whole);
    key_grid grid;
    for (uint axis = 0; axis < 3; ++axis) grid.low[axis] = whole.low[axis];
    grid.bits = triangles_are_incoherent(whole) ? RSH_FINE_BITS : cell_bits;
    grid.cell_bits = cell_bits;
    grid.bin_shift = 3 * (grid.bits - cell_bits);
    grid.scale = cells_per_length(longest, grid.bits);
    grid.large = RSH_LARGE * longest;
    return grid;
}

RSH_CALLED static void keys_of_boxes(const boxes16* boxes, key_grid grid, uint* keys)
{
    const uint large_cells = 1u << (3 * grid.cell_bits - 6);
    for (uint first = 0; first < RSH_VECTORS; first += RSH_ABREAST) {
        uintv cell[3][RSH_ABREAST], place[RSH_ABREAST];
        intv is_large[RSH_ABREAST];
        for_each_abreast(v) {
            is_large[v] = (intv)(0);
            for (uint axis = 0; axis < 3; ++axis) {
                const floatv low = boxes->low[axis][first + v];
                const floatv high = boxes->high[axis][first + v];
                cell[axis][v] =
                    cell_of(0.5f * low + 0.5f * high, grid.low[axis], grid.scale, grid.bits);
                is_large[v] |= high - low > (floatv)(grid.large);
            }
        }
        hilbert_places(cell[0], cell[1], cell[2], grid.bits, place);
        for_each_abreast(v) {
            const uintv small = place[v] + (large_cells << grid.bin_shift);
            store_lanes(select(small, place[v] >> 6, as_uintv(is_large[v])),
                        keys + RSH_WIDTH * (first + v));
        }
    }
}

/* A tree that lies where others did leaves none of them. */
static void mark_as_not_made(__global float* bvh, bvh_layout layout)
{
    __global bvh_head* head = head_of(bvh);
    head->made[layout.tree] = head->joined = 0;
    if (are_laid_out_as(bvh, layout.whole)) return;
    head->made[RSH_STILL_TREE] = head->made[RSH_MOVING_TREE] = 0;
    head->whole = layout.whole;
}

/* Keys of all triangles, and how many of them are in each cell. */
RSH_CALLED static void write_keys(const order_state* state, uint cell_bits, range16 mine,
                                  __global uint* keys, __global uint* bins)
{
    const key_grid grid = grid_of(state->samples, state->items, cell_bits);
    if (state->item == 0) {
        state->sorting->bin_shift = grid.bin_shift;
        mark_as_not_made(state->bvh, state->layout);
    }
    __global uint* own = bins + (ulong)RSH_ORDER_BINS(cell_bits) * state->item;
    for (uint b = 0; b < RSH_ORDER_BINS(cell_bits); ++b) own[b] = 0;
    for (uint g = mine.begin; g < mine.end; ++g) {
        corner_rows corners;
        boxes16 boxes;
        uint key[16];
        load_corners(state->mesh, state->vertices, state->indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
        keys_of_boxes(&boxes, grid, key);
        store_keys(key, g, state->mesh.triangle_count, grid.bin_shift, keys, own);
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_order(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, bvh_layout layout, uint pass,
                        uint is_refit, uint cell_bits, __global refit_quality* now,
                        __global float* bvh, __global sample_bounds* samples,
                        __global sort_plan* sorting, __global uint* keys, __global uint* bins,
                        volatile __global uint* wrong)
{
    const order_state state = {mesh,   vertices,         indices,
                               layout, get_global_id(0), get_global_size(0),
                               bvh,    samples,          sorting};
    __global refit_quality* made = (__global refit_quality*)(bvh + RSH_QUALITY_AT(layout));
    const range16 mine = my_range16(mesh.triangle_count, state.items);
    if (pass == RSH_QUALITY_PASS && is_tree_made(bvh, layout.whole, layout.tree))
        measure_quality(&state, now);
    if (pass == RSH_SAMPLE_PASS) {
        if (is_refit && state.item == 0 && !can_refit(bvh, layout))
            atomic_or(wrong, RSH_WRONG_BOUNDS);
        sample_range(&state, keeps_order(is_refit, now, bvh, layout), mine);
    }
    if (pass == RSH_KEYS_PASS && sorting->is_needed)
        write_keys(&state, cell_bits, mine, keys, bins);
    if (pass == RSH_RECORD_PASS && sorting->is_needed) measure_quality(&state, made);
}
