/* order_boxes.cl - Morton order for what bound_boxes.cl bounds, remade every frame: of
 * clusters, or of the triangles themselves where runs of 16 of them are no neighbours.
 *   unordered  in   groups of clusters in index order, the boxes that rsh_bound_triangles made
 *   boxes      out  see scene_boxes.h
 * A counting sort of 22-bit keys in two passes; each work-item has a run of the elements and
 * its own counts. Which of the two is ordered is decided on the device, from the clusters' own
 * size. */
#include "bound_boxes.h"

static float surface_of(const float* low, const float* high)
{
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    const float area = x * y + y * z + z * x;
    return x >= 0.0f && isfinite(area) ? area : 0.0f;
}

/* Of the boxes of a group that hold something. */
static float surface_of_group(__global const float* group)
{
    floatv sum = (floatv)(0.0f);
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        floatv side[3];
        for (uint axis = 0; axis < 3; ++axis)
            side[axis] = load_lanes(group + 48 + 16 * axis + RSH_WIDTH * v) -
                         load_lanes(group + 16 * axis + RSH_WIDTH * v);
        const floatv area = side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
        sum += select((floatv)(0.0f), area,
                      (side[0] >= (floatv)(0.0f)) & (area < (floatv)(INFINITY)));
    }
    float lane[RSH_WIDTH], total = 0.0f;
    store_lanes(sum, lane);
    for (uint i = 0; i < RSH_WIDTH; ++i) total += lane[i];
    return total;
}

static void box_in(__global const float* group, uint k, float* low, float* high)
{
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = group[16 * axis + k];
        high[axis] = group[48 + 16 * axis + k];
    }
}

typedef struct rsh_part {
    uint begin, end;
} rsh_part;

/* Of `count` elements in groups of 16, the groups of work-item `item`. */
static rsh_part my_groups(uint count, uint item)
{
    const uint groups = (count + 15) / 16, items = get_global_size(0);
    const uint run = (groups + items - 1) / items;
    const uint begin = min(groups, run * item);
    return (rsh_part){begin, min(groups, begin + run)};
}

/* Neighbours on a surface share their boxes' surface; strangers span the space between them. */
#define RSH_SPARSE 4.0f

/* One cluster in 64 is asked how its triangles fill it. */
static void ask_cluster(__global const float* boxes, __global const float* unordered,
                        uint cluster, rsh_scene_extent* extent)
{
    float low[3], high[3];
    box_in(unordered + RSH_GROUP_WORDS * (cluster / 16), cluster % 16, low, high);
    const float whole = surface_of(low, high);
    const float filled = surface_of_group(boxes + RSH_GROUP_WORDS * cluster);
    ++extent->asked;
    if (whole > RSH_SPARSE * filled)
        ++extent->sparse;
    else
        extent->surface += whole;
}

__kernel void rsh_order_measure(rsh_box_levels levels, __global const float* boxes,
                                __global const float* unordered,
                                __global rsh_scene_extent* extents)
{
    const rsh_part mine = my_groups(levels.boxes[1], get_global_id(0));
    rsh_scene_extent extent = {
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, 0, 0.0f, 0.0f};
    for (uint g = mine.begin; g < mine.end; ++g) {
        __global const float* group = unordered + RSH_GROUP_WORDS * g;
        for (uint axis = 0; axis < 3; ++axis) {
            extent.low[axis] = fmin(extent.low[axis], smallest_in_row(group + 16 * axis));
            extent.high[axis] = fmax(extent.high[axis], largest_in_row(group + 48 + 16 * axis));
        }
        if (g % 4 == 0) ask_cluster(boxes, unordered, 16 * g, &extent);
    }
    extents[get_global_id(0)] = extent;
}

/* What all work-items saw; each adds it up for itself. */
static rsh_scene_extent whole_extent(__global const rsh_scene_extent* extents, uint count)
{
    rsh_scene_extent whole = extents[0];
    for (uint i = 1; i < count; ++i) {
        for (uint axis = 0; axis < 3; ++axis) {
            whole.low[axis] = fmin(whole.low[axis], extents[i].low[axis]);
            whole.high[axis] = fmax(whole.high[axis], extents[i].high[axis]);
        }
        whole.asked += extents[i].asked;
        whole.sparse += extents[i].sparse;
        whole.surface += extents[i].surface;
    }
    return whole;
}

/* Then the order of the triangles themselves is worth its price. Some clusters always are:
 * those that end one object and begin the next. */
static bool is_sparse(rsh_scene_extent extent) { return extent.sparse > extent.asked / 4; }

/* Every third bit, from the lower 8. */
static uintv spread_bits(uintv x)
{
    x = (x | x << 8) & 0x00f00fu;
    x = (x | x << 4) & 0x0c30c3u;
    return (x | x << 2) & 0x249249u;
}

/* Keys of 16 boxes: their centres' cells in a grid of 256 along the longest side, Morton order,
 * without the lowest two bits. Boxes that hold nothing go last. */
static void keys_of_group(__global const float* group, rsh_scene_extent extent, uint* keys)
{
    float longest = 0.0f;
    for (uint axis = 0; axis < 3; ++axis)
        longest = fmax(longest, extent.high[axis] - extent.low[axis]);
    const float scale = longest > 0.0f && isfinite(longest) ? 255.0f / longest : 0.0f;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        uintv code = (uintv)(0);
        intv is_full = (intv)(-1);
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv low = load_lanes(group + 16 * axis + RSH_WIDTH * v);
            const floatv high = load_lanes(group + 48 + 16 * axis + RSH_WIDTH * v);
            const floatv cell = (0.5f * low + 0.5f * high - extent.low[axis]) * scale;
            is_full &= low <= high;
            code |= spread_bits(convert_uintv_sat(cell) & 0xffu) << (2 - axis);
        }
        store_lanes(select((uintv)(0xffffffu), code, as_uintv(is_full)) >> 2,
                    keys + RSH_WIDTH * v);
    }
}

typedef struct rsh_sorting {
    uint count;       /* elements */
    uint first_group; /* with their boxes */
    bool is_sparse;
} rsh_sorting;

static rsh_sorting sorting_of(rsh_box_levels levels, __global const rsh_scene_extent* extents)
{
    const bool by_triangle = is_sparse(whole_extent(extents, get_global_size(0)));
    return (rsh_sorting){levels.boxes[by_triangle ? 0 : 1], 0, by_triangle};
}

static void clear_bins(__global uint* bins)
{
    for (uint b = 0; b < RSH_ORDER_BINS; ++b) bins[b] = 0;
}

/* Keys of all elements, and how many have each lower half. */
__kernel void rsh_order_keys(rsh_box_levels levels, __global const float* boxes,
                             __global const float* unordered,
                             __global const rsh_scene_extent* extents, __global uint* keys,
                             __global uint* bins)
{
    const uint me = get_global_id(0);
    const rsh_scene_extent whole = whole_extent(extents, get_global_size(0));
    const rsh_sorting sorting = sorting_of(levels, extents);
    const rsh_part mine = my_groups(sorting.count, me);
    __global const float* elements = sorting.is_sparse ? boxes : unordered;
    __global uint* own = bins + RSH_ORDER_BINS * me;
    clear_bins(own);
    for (uint g = mine.begin; g < mine.end; ++g) {
        uint key[16];
        keys_of_group(elements + RSH_GROUP_WORDS * g, whole, key);
        for (uint k = 0; k < 16 && 16 * g + k < sorting.count; ++k) {
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

/* By the lower half; the upper half and the element itself go along. */
__kernel void rsh_order_scatter_low(rsh_box_levels levels,
                                    __global const rsh_scene_extent* extents,
                                    __global const uint* keys, __global uint* bins,
                                    __global uint2* half_sorted)
{
    const uint me = get_global_id(0);
    const rsh_sorting sorting = sorting_of(levels, extents);
    const rsh_part mine = my_groups(sorting.count, me);
    __global uint* own = bins + RSH_ORDER_BINS * me;
    for (uint i = 16 * mine.begin; i < min(16 * mine.end, sorting.count); ++i)
        half_sorted[own[keys[i] % RSH_ORDER_BINS]++] = (uint2)(keys[i] / RSH_ORDER_BINS, i);
}

__kernel void rsh_order_count_high(rsh_box_levels levels,
                                   __global const rsh_scene_extent* extents,
                                   __global const uint2* half_sorted, __global uint* bins)
{
    const uint me = get_global_id(0);
    const rsh_sorting sorting = sorting_of(levels, extents);
    const rsh_part mine = my_groups(sorting.count, me);
    __global uint* own = bins + RSH_ORDER_BINS * me;
    clear_bins(own);
    for (uint i = 16 * mine.begin; i < min(16 * mine.end, sorting.count); ++i)
        ++own[half_sorted[i].x];
}

/* By the upper half: the order of clusters, or that of triangles. */
__kernel void rsh_order_scatter_high(rsh_box_levels levels,
                                     __global const rsh_scene_extent* extents,
                                     __global const uint2* half_sorted, __global uint* bins,
                                     __global uint* boxes)
{
    const uint me = get_global_id(0);
    const rsh_sorting sorting = sorting_of(levels, extents);
    const rsh_part mine = my_groups(sorting.count, me);
    __global uint* own = bins + RSH_ORDER_BINS * me;
    __global uint* order = boxes + (sorting.is_sparse ? order_at(levels) : children_at(levels));
    for (uint i = 16 * mine.begin; i < min(16 * mine.end, sorting.count); ++i)
        order[own[half_sorted[i].x]++] = half_sorted[i].y;
    if (me != 0) return;
    const rsh_scene_extent whole = whole_extent(extents, get_global_size(0));
    boxes[is_ordered_at(levels)] = sorting.is_sparse;
    boxes[cluster_size_at(levels)] =
        as_uint(whole.surface / (float)max(1u, whole.asked - whole.sparse));
}

/* Level 1 in its new order. A work-item makes a group of it. */
__kernel void rsh_order_clusters(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_box_levels levels,
                                 __global const float* unordered, __global float* boxes)
{
    const uint me = get_global_id(0), clusters = levels.boxes[1];
    if (me >= (clusters + 15) / 16) return; /* launch is rounded up to whole groups */
    __global uint* words = (__global uint*)boxes;
    __global uint* children = words + children_at(levels);
    float row[6][16];
    for (uint k = 0; k < 16; ++k) {
        const uint cluster = 16 * me + k;
        float around[6];
        clear_box(around);
        if (cluster < clusters && words[is_ordered_at(levels)]) {
            bound_cluster(mesh, vertices, indices, words + order_at(levels), cluster, boxes,
                          around);
            children[cluster] = cluster;
        } else if (cluster < clusters) {
            const uint from = children[cluster];
            box_in(unordered + RSH_GROUP_WORDS * (from / 16), from % 16, around, around + 3);
        }
        for (uint f = 0; f < 6; ++f) row[f][k] = around[f];
    }
    store_group(row, boxes + RSH_GROUP_WORDS * (levels.first_group[1] + me));
}
