/* leaves.cl - clusters of triangles that lie close together, and groups of clusters and
 * groups, up to one. For this frame alone, groups are runs along the curve as clusters are;
 * where they are to be kept, they come out of a binary tree, which pays over some frames.
 *   vertices, indices  in      triangles
 *   spans              in      the scene's extent, from rsh_order_measure
 *   boxes              in/out  see bvh/layout.h; in: the order of the triangles
 *   loose              -       boxes around clusters, by their numbers, then around groups
 *   tree               -       RSH_TREE_WORDS; see kernel_types.h
 * Nothing is done where the order is the one that there was: bvh/refit.cl.
 * Does not look at rays.
 */
#include "bvh/collapse16.h"
#include "bvh/leaf_cuts.h"
#include "bvh/nodes_from_runs.h"
#include "bvh/ploc.h"
#include "order/sort.h"

/* What a run costs besides its surface, as a part of the scene's by the number of runs. The
 * mean surface of clusters is 3 to 9 times that; between a tenth and two thirds of it, what
 * rays open hardly changes. */
#define RSH_PRICE 1.5f
#define RSH_RUN_PRICE (RSH_MEAN_RUN * RSH_PRICE) /* the same of groups */

/* A cluster's share of the scene's surface; never 0, so that each has a price. */
static float share_of(const rsh_span* scene, uint triangles)
{
    const float surface = surface_of(scene->low, scene->high);
    return clamp(surface * RSH_MEAN_RUN / (float)triangles, 1e-30f, RSH_MOST_SURFACE);
}

/* A part of the triangles on its way into clusters: some of them in a row. */
typedef struct rsh_part_in {
    rsh_row row; /* boxes around triangles, not padded */
    float corner[9][RSH_WINDOW + 16];
    uint triangle[RSH_WINDOW + 16]; /* numbers */
    uint next, end;                 /* places of those not in the row yet */
    uint clusters, first_cluster;   /* made so far, and the number of the first */
    uint cut;                       /* triangles in these */
} rsh_part_in;

/* clusters: where they will be stored, in bursts that should find their lines in the cache. */
static void load_triangles(rsh_part_in* part, rsh_mesh mesh, __global const float* vertices,
                           __global const uint* indices, __global const uint* order,
                           __global const float* clusters)
{
    for (; part->row.count + 16 <= RSH_WINDOW && part->next < part->end; part->next += 16) {
        const uint at = part->row.count;
        rsh_corner_rows corners;
        rsh_boxes boxes;
        load_corners(mesh, vertices, indices, order, part->next, &corners);
        boxes_of_corners(&corners, &boxes);
        for (uint v = 0; v < RSH_VECTORS; ++v) {
#pragma unroll
            for (uint axis = 0; axis < 3; ++axis) {
                store_whole(__private, boxes.low[axis][v],
                            part->row.side[axis] + at + RSH_WIDTH * v);
                store_whole(__private, boxes.high[axis][v],
                            part->row.side[3 + axis] + at + RSH_WIDTH * v);
            }
#pragma unroll
            for (uint i = 0; i < 9; ++i)
                store_whole(__private, corners.row[i / 3][i % 3][v],
                            part->corner[i] + at + RSH_WIDTH * v);
            store_whole_uint(__private, triangles_from(mesh, order, part->next + RSH_WIDTH * v),
                             part->triangle + at + RSH_WIDTH * v);
        }
        expect_stores(clusters + cluster_at(part->first_cluster + part->clusters + at / 15));
        part->row.count += min(16u, part->end - part->next);
    }
}

/* A part with more clusters than it has room for goes on with full ones: at least 14 triangles
 * to each on the average, but for three. */
static void cut_triangles(rsh_part_in* part, float price)
{
    const bool is_last = part->next >= part->end;
    cut_row(&part->row, price, is_last);
    uint done = part->cut;
    for (uint r = 0; r < part->row.runs; ++r) done += part->row.run[r];
    if (14 * (part->clusters + part->row.runs) > done + 28) cut_evenly(&part->row, is_last);
}

/* Returns whether mesh/intersect.h has any of the triangles to scale. */
static bool store_cluster(const rsh_part_in* part, uint first, uint length,
                          __global float* cluster)
{
    rsh_corner_rows corners;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const intv is_there = RSH_LANES + (int)(RSH_WIDTH * v) < (intv)((int)length);
#pragma unroll
        for (uint i = 0; i < 9; ++i)
            corners.row[i / 3][i % 3][v] =
                select((floatv)(INFINITY), load_lanes(part->corner[i] + first + RSH_WIDTH * v),
                       is_there);
        const uintv triangle =
            select((uintv)(RSH_NO_HIT), load_lanes(part->triangle + first + RSH_WIDTH * v),
                   as_uintv(is_there));
        store_whole_uint(__global, triangle, cluster + RSH_TRIANGLES_AT + RSH_WIDTH * v);
    }
    store_corners(&corners, cluster);
    return is_any_scaled(&corners);
}

static void clear_clusters(__global float* cluster, uint count)
{
    for (; count > 0; --count, cluster += RSH_CLUSTER_WORDS) {
        for (uint i = 0; i < 9; ++i) vstore16((float16)(INFINITY), i, cluster);
        vstore16((uint16)(RSH_NO_HIT), 0, (__global uint*)cluster + RSH_TRIANGLES_AT);
    }
}

/* And leaves the boxes around them in `loose`. */
static void store_clusters(rsh_part_in* part, __global float* boxes,
                           __global rsh_loose_box* loose)
{
    uint first = 0;
    for (uint r = 0; r < part->row.runs; ++r) {
        const uint length = part->row.run[r];
        const uint cluster = part->first_cluster + part->clusters++;
        rsh_loose_box around;
        bound_run(&part->row, first, length, around.side);
        pad_box(around.side);
        const bool is_scaled = store_cluster(part, first, length, boxes + cluster_at(cluster));
        around.below = below_cluster(cluster, is_scaled);
        loose[cluster] = around;
        first += length;
    }
    part->cut += first;
    shift_row(&part->row, first);
    for (uint i = 0; i < 9; ++i) shift_words(part->corner[i], first, part->row.count);
    shift_words((float*)part->triangle, first, part->row.count);
}

/* Up to the highest branches of a part. */
static void grow_part(const rsh_tree* tree, float price, uint part, uint clusters)
{
    const uint first = part * tree->shape.part_clusters;
    rsh_tops tops = no_tops(tree, part);
    for (uint c = 0; c < clusters; ++c) add_top(tree, &tops, first + c);
    grow_tree(tree, price, &tops, RSH_CLUSTERS(tree->shape) + first, RSH_PART_TOPS);
    __global rsh_tree_part* made = tree->parts + part;
    for (uint i = 0; i < tops.count; ++i) made->top[i] = tops.number[i];
    made->tops = tops.count;
    made->waiting = RSH_NO_BRANCH;
    made->first_group = (part + 1) * tree->shape.part_groups;
}

/* A work-item makes the clusters of a part, and the groups or the tree above them. */
__kernel void rsh_bound_clusters(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_scene_shape scene_shape,
                                 __global const rsh_sorting* sorting, uint span_count,
                                 __global const rsh_span* spans, uint is_kept,
                                 __global float* boxes, __global rsh_loose_box* loose,
                                 __global float* tree)
{
    const rsh_scene_shape shape = scene_shape;
    const uint me = get_global_id(0);
    if (me >= shape.parts) return; /* launch is rounded up to whole groups */
    if (!sorting->is_needed) return;
    __global const uint* order = (__global const uint*)boxes + RSH_ORDER_AT(shape);
    const rsh_span scene = whole_span(spans, span_count);
    const float share = share_of(&scene, shape.triangles);
    rsh_part_in part;
    part.row.count = part.clusters = part.cut = 0;
    part.first_cluster = me * shape.part_clusters;
    part.next = me * shape.part;
    part.end = min(part.next + shape.part, shape.triangles);
    while (part.next < part.end || part.row.count) {
        load_triangles(&part, mesh, vertices, indices, order, boxes);
        cut_triangles(&part, RSH_PRICE * share);
        store_clusters(&part, boxes, loose);
    }
    __global rsh_part_counts* counts = part_counts(&shape, boxes) + me;
    counts->clusters = part.clusters;
    clear_clusters(boxes + cluster_at(part.first_cluster + part.clusters),
                   shape.part_clusters - part.clusters);
    if (!is_kept) {
        counts->groups =
            group_part(&shape, RSH_RUN_PRICE * share, me, part.clusters, boxes, loose);
        return;
    }
    const rsh_tree growing = tree_in(shape, loose, tree);
    grow_part(&growing, RSH_GROUP_PRICE * share, me, part.clusters);
}

/* Groups of the parts' groups; one work-item: there are 200 times fewer than triangles. */
__kernel void rsh_bound_levels(rsh_scene_shape scene_shape, __global const rsh_sorting* sorting,
                               uint span_count, __global const rsh_span* spans,
                               __global float* boxes, __global rsh_loose_box* loose)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const rsh_scene_shape shape = scene_shape;
    const rsh_span scene = whole_span(spans, span_count);
    const float price = RSH_RUN_PRICE * share_of(&scene, shape.triangles);
    const rsh_group_range groups = group_levels(&shape, RSH_MEAN_RUN * price, boxes, loose);
    *bounds_head(boxes) = (rsh_bounds_head){RSH_BOUNDS_MADE, shape, groups};
}

/* The tree above the parts, and the groups at its top; one work-item: a part leaves 4 boxes. */
__kernel void rsh_bound_top(rsh_scene_shape scene_shape, __global const rsh_sorting* sorting,
                            uint span_count, __global const rsh_span* spans,
                            __global float* boxes, __global const rsh_loose_box* loose,
                            __global float* tree)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const rsh_scene_shape shape = scene_shape;
    const rsh_span scene = whole_span(spans, span_count);
    const float price = RSH_GROUP_PRICE * share_of(&scene, shape.triangles);
    const rsh_tree growing = tree_in(shape, loose, tree);
    rsh_tops tops = no_tops(&growing, shape.parts);
    for (uint p = 0; p < shape.parts; ++p)
        for (uint i = 0; i < growing.parts[p].tops; ++i)
            add_top(&growing, &tops, growing.parts[p].top[i]);
    grow_tree(&growing, price, &tops, 2 * RSH_CLUSTERS(shape), 1);
    __global rsh_tree_part* above = growing.parts + shape.parts;
    const uint end = RSH_GROUPS(shape);
    above->waiting = RSH_NO_BRANCH;
    above->first_group = end - 1;
    make_group(&growing, tops.number[0], end - 1, boxes);
    make_waiting_groups(&growing, above, boxes);
    *bounds_head(boxes) = (rsh_bounds_head){0, shape, {above->first_group, end}};
}

/* What a part has, and will be read in no order. */
static void expect_part(const rsh_tree* tree, uint part)
{
#ifdef RSH_EXPECT_LOAD
    const uint room = tree->shape.part_clusters, first = part * room;
    for (uint i = 0; i < room; ++i) RSH_EXPECT_LOAD(tree->branches + first + i);
    for (uint i = 0; i < room; i += 2) RSH_EXPECT_LOAD(tree->clusters + first + i);
#endif
}

/* A work-item makes the groups of a part. Nothing is left to be done after that. */
__kernel void rsh_bound_groups(rsh_scene_shape scene_shape, __global const rsh_sorting* sorting,
                               __global float* boxes, __global const rsh_loose_box* loose,
                               __global float* tree)
{
    const rsh_scene_shape shape = scene_shape;
    const uint me = get_global_id(0);
    if (me >= shape.parts) return; /* launch is rounded up to whole groups */
    if (!sorting->is_needed) return;
    const rsh_tree grown = tree_in(shape, loose, tree);
    expect_part(&grown, me);
    make_waiting_groups(&grown, grown.parts + me, boxes);
    part_counts(&shape, boxes)[me].groups =
        (rsh_group_range){grown.parts[me].first_group, (me + 1) * shape.part_groups};
    if (me == 0) bounds_head(boxes)->made = RSH_BOUNDS_MADE;
}
