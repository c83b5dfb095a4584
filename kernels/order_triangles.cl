/* order_triangles.cl - the order in which triangles make clusters, remade every frame: along
 * Hilbert's curve; the few that are large against the scene first, lest every box that holds
 * one of them among small ones becomes large.
 *   vertices, indices  in   triangles
 *   boxes              out  their order; see scene_boxes.h
 * A counting sort of 22-bit keys in two passes; each work-item has a run of the elements and
 * its own counts.
 */
#include "bound_boxes.h"
#include "hilbert.h"

/* Longest side of a large triangle's box, of that of the scene. */
#define RSH_LARGE 0.125f

/* Triangles in groups of 16, cut into runs. */
typedef struct rsh_part {
    uint begin, end;
} rsh_part;

static rsh_part my_groups(uint count)
{
    const uint groups = (count + 15) / 16, items = get_global_size(0);
    const uint run = (groups + items - 1) / items;
    const uint begin = min(groups, run * (uint)get_global_id(0));
    return (rsh_part){begin, min(groups, begin + run)};
}

static rsh_part my_triangles(uint count)
{
    const rsh_part groups = my_groups(count);
    return (rsh_part){16 * groups.begin, min(16 * groups.end, count)};
}

/* What a group in 16 spans: keys take what lies outside for its margin. */
#define RSH_ASKED 16

__kernel void rsh_order_measure(rsh_mesh mesh, __global const float* vertices,
                                __global const uint* indices,
                                __global rsh_scene_extent* extents)
{
    const rsh_part mine = my_groups(mesh.triangle_count);
    rsh_boxes span;
    for (uint i = 0; i < 3 * RSH_VECTORS; ++i) {
        span.low[i / RSH_VECTORS][i % RSH_VECTORS] = (floatv)(INFINITY);
        span.high[i / RSH_VECTORS][i % RSH_VECTORS] = (floatv)(-INFINITY);
    }
    for (uint g = mine.begin; g < mine.end; g += RSH_ASKED) {
        rsh_corner_rows corners;
        rsh_boxes boxes;
        load_corners(mesh, vertices, indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
#pragma unroll
        for (uint axis = 0; axis < 3; ++axis)
            for (uint v = 0; v < RSH_VECTORS; ++v) {
                span.low[axis][v] = lesser(boxes.low[axis][v], span.low[axis][v]);
                span.high[axis][v] = greater(boxes.high[axis][v], span.high[axis][v]);
            }
    }
    rsh_scene_extent extent;
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis) {
        extent.low[axis] = smallest_lane(span.low[axis]);
        extent.high[axis] = largest_lane(span.high[axis]);
    }
    extents[get_global_id(0)] = extent;
}

/* Where a cell of the curve lies: (position - low) * scale. */
typedef struct rsh_grid {
    float low[3], scale, large;
} rsh_grid;

static rsh_grid grid_of(__global const rsh_scene_extent* extents)
{
    rsh_scene_extent whole = extents[0];
    for (uint i = 1; i < get_global_size(0); ++i)
#pragma unroll
        for (uint axis = 0; axis < 3; ++axis) {
            whole.low[axis] = fmin(whole.low[axis], extents[i].low[axis]);
            whole.high[axis] = fmax(whole.high[axis], extents[i].high[axis]);
        }
    rsh_grid grid;
    float longest = 0.0f;
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis) {
        grid.low[axis] = whole.low[axis];
        longest = fmax(longest, whole.high[axis] - whole.low[axis]);
    }
    const float cells = (1 << RSH_HILBERT_BITS) - 1;
    grid.scale = longest > 0.0f && isfinite(longest) ? cells / longest : 0.0f;
    grid.large = RSH_LARGE * longest;
    return grid;
}

static void keys_of_boxes(const rsh_boxes* boxes, rsh_grid grid, uint* keys)
{
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        uintv cell[3];
        intv is_large = (intv)(0);
#pragma unroll
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv low = boxes->low[axis][v], high = boxes->high[axis][v];
            const floatv at = (0.5f * low + 0.5f * high - grid.low[axis]) * grid.scale;
            const floatv last = (floatv)((1 << RSH_HILBERT_BITS) - 1);
            cell[axis] = as_uintv(convert_intv(greater(lesser(at, last), (floatv)(0.0f))));
            is_large |= high - low > (floatv)(grid.large);
        }
        const uintv small = select((uintv)(1u << 3 * RSH_HILBERT_BITS), (uintv)(0u),
                                   as_uintv(is_large));
        store_lanes(hilbert_place(cell) | small, keys + RSH_WIDTH * v);
    }
}

static void clear_bins(__global uint* bins)
{
    for (uint b = 0; b < RSH_ORDER_BINS; ++b) bins[b] = 0;
}

/* Keys of all triangles, and how many have each lower half. */
__kernel void rsh_order_keys(rsh_mesh mesh, __global const float* vertices,
                             __global const uint* indices,
                             __global const rsh_scene_extent* extents, __global uint* keys,
                             __global uint* bins)
{
    const rsh_part mine = my_groups(mesh.triangle_count);
    const rsh_grid grid = grid_of(extents);
    __global uint* own = bins + RSH_ORDER_BINS * get_global_id(0);
    clear_bins(own);
    for (uint g = mine.begin; g < mine.end; ++g) {
        rsh_corner_rows corners;
        rsh_boxes boxes;
        uint key[16];
        load_corners(mesh, vertices, indices, 0, 16 * g, &corners);
        boxes_of_corners(&corners, &boxes);
        keys_of_boxes(&boxes, grid, key);
        for (uint k = 0; k < 16 && 16 * g + k < mesh.triangle_count; ++k) {
            keys[16 * g + k] = key[k];
            ++own[key[k] % RSH_ORDER_BINS];
        }
    }
}

/* Counts to places: of all elements in lower bins, and in this bin before this work-item. */
__kernel void rsh_order_scan(uint items, __global uint* bins)
{
    if (get_global_id(0) != 0) return;
    uint sum = 0;
    for (uint b = 0; b < RSH_ORDER_BINS; ++b)
        for (uint i = 0; i < items; ++i) {
            const uint count = bins[RSH_ORDER_BINS * i + b];
            bins[RSH_ORDER_BINS * i + b] = sum;
            sum += count;
        }
}

/* By the lower half: the upper one and the triangle. */
__kernel void rsh_order_scatter_low(uint count, __global const uint* keys, __global uint* bins,
                                    __global uint2* half_sorted)
{
    const rsh_part mine = my_triangles(count);
    __global uint* own = bins + RSH_ORDER_BINS * get_global_id(0);
    for (uint i = mine.begin; i < mine.end; ++i)
        half_sorted[own[keys[i] % RSH_ORDER_BINS]++] = (uint2)(keys[i] / RSH_ORDER_BINS, i);
}

__kernel void rsh_order_count_high(uint count, __global const uint2* half_sorted,
                                   __global uint* bins)
{
    const rsh_part mine = my_triangles(count);
    __global uint* own = bins + RSH_ORDER_BINS * get_global_id(0);
    clear_bins(own);
    for (uint i = mine.begin; i < mine.end; ++i) ++own[half_sorted[i].x];
}

/* By the upper half: the order. */
__kernel void rsh_order_scatter_high(rsh_box_levels shape, __global const uint2* half_sorted,
                                     __global uint* bins, __global uint* boxes)
{
    const rsh_box_levels levels = shape;
    const rsh_part mine = my_triangles(levels.boxes[0]);
    __global uint* own = bins + RSH_ORDER_BINS * get_global_id(0);
    __global uint* order = boxes + order_at(&levels);
    for (uint i = mine.begin; i < mine.end; ++i)
        order[own[half_sorted[i].x]++] = half_sorted[i].y;
}
