/* bound_boxes.cl - clusters of triangles that lie close together, groups of clusters, groups of
 * groups, and so on up to one.
 *   vertices, indices  in      triangles
 *   spans              in      the scene's extent, from rsh_order_measure
 *   boxes              in/out  see scene_boxes.h; in: the order of the triangles
 *   loose              -       boxes around groups that are in no group yet, by their numbers
 * Nothing is done where the order is the one that there was: refit_boxes.cl.
 * Does not look at rays.
 */
#include "bound_boxes.h"
#include "cut_boxes.h"
#include "sort.h"

/* What a run costs besides its surface, as a part of the scene's by the number of runs. The
 * mean surface of clusters is 3 to 9 times that; between a tenth and two thirds of it, what
 * rays open hardly changes. */
#define RSH_PRICE 1.5f

/* Of groups there are so many fewer. */
#define RSH_MEAN_RUN 14.0f

static float price_of(const rsh_span* scene, float runs)
{
    const float surface = surface_of(scene->low, scene->high);
    return fmin(RSH_PRICE * surface / fmax(runs, 1.0f), RSH_MOST_SURFACE);
}

/* A part of the triangles on its way into clusters: some of them in a row. */
typedef struct rsh_part_in {
    rsh_row row;                            /* boxes around triangles, not padded */
    float corner[9][RSH_WINDOW + 16];
    uint triangle[RSH_WINDOW + 16];         /* numbers */
    uint next, end;                         /* places of those not in the row yet */
    uint clusters, first_cluster;           /* made so far, and the number of the first */
    uint cut;                               /* triangles in these */
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

/* Returns whether intersect.h has any of the triangles to scale. */
static bool store_cluster(const rsh_part_in* part, uint first, uint length,
                          __global float* cluster)
{
    rsh_corner_rows corners;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const intv is_there = RSH_LANES + (int)(RSH_WIDTH * v) < (intv)((int)length);
#pragma unroll
        for (uint i = 0; i < 9; ++i)
            corners.row[i / 3][i % 3][v] =
                select((floatv)(INFINITY),
                       load_lanes(part->corner[i] + first + RSH_WIDTH * v), is_there);
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

/* Boxes on their way into groups. */
typedef struct rsh_level_in {
    rsh_row row;
    uint below[RSH_WINDOW + 16];
    uint next_group; /* number */
} rsh_level_in;

static void add_box(rsh_level_in* level, const float* side, uint below)
{
    for (uint f = 0; f < 6; ++f) level->row.side[f][level->row.count] = side[f];
    level->below[level->row.count++] = below;
}

static void store_group(const rsh_level_in* level, uint first, uint length,
                        __global float* group)
{
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const intv is_there = RSH_LANES + (int)(RSH_WIDTH * v) < (intv)((int)length);
#pragma unroll
        for (uint f = 0; f < 6; ++f)
            store_lanes(select((floatv)(f < 3 ? INFINITY : -INFINITY),
                               load_lanes(level->row.side[f] + first + RSH_WIDTH * v),
                               is_there),
                        group + 16 * f + RSH_WIDTH * v);
        store_lanes(select((uintv)(level->below[first]),
                           load_lanes(level->below + first + RSH_WIDTH * v),
                           as_uintv(is_there)),
                    (__global uint*)group + RSH_BELOW_AT + RSH_WIDTH * v);
    }
}

/* Stores the runs of the row as groups; returns how many, and their boxes in `loose`. */
static uint store_groups(rsh_level_in* level, const rsh_scene_shape* shape,
                         __global float* boxes, __global rsh_loose_box* loose)
{
    uint first = 0;
    for (uint r = 0; r < level->row.runs; ++r) {
        const uint length = level->row.run[r], group = level->next_group++;
        store_group(level, first, length, boxes + box_group_at(shape, group));
        rsh_loose_box around;
        bound_run(&level->row, first, length, around.side);
        around.below = group;
        loose[r] = around;
        first += length;
    }
    shift_row(&level->row, first);
    shift_words((float*)level->below, first, level->row.count);
    return level->row.runs;
}

static void store_clusters(rsh_part_in* part, __global float* boxes, rsh_level_in* level)
{
    uint first = 0;
    for (uint r = 0; r < part->row.runs; ++r) {
        const uint length = part->row.run[r];
        const uint cluster = part->first_cluster + part->clusters++;
        float side[6];
        bound_run(&part->row, first, length, side);
        pad_box(side);
        const bool is_scaled = store_cluster(part, first, length, boxes + cluster_at(cluster));
        add_box(level, side, cluster | (is_scaled ? RSH_SCALED : 0));
        first += length;
    }
    part->cut += first;
    shift_row(&part->row, first);
    for (uint i = 0; i < 9; ++i) shift_words(part->corner[i], first, part->row.count);
    shift_words((float*)part->triangle, first, part->row.count);
}

/* A work-item makes the clusters of a part, and their groups. */
__kernel void rsh_bound_clusters(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_scene_shape scene_shape,
                                 __global const rsh_sorting* sorting, uint span_count,
                                 __global const rsh_span* spans, __global float* boxes,
                                 __global rsh_loose_box* loose)
{
    const rsh_scene_shape shape = scene_shape;
    const uint me = get_global_id(0);
    if (me >= shape.parts) return; /* launch is rounded up to whole groups */
    if (!sorting->is_needed) return;
    __global const uint* order = (__global const uint*)boxes + RSH_ORDER_AT(shape);
    const rsh_span scene = whole_span(spans, span_count);
    const float price = price_of(&scene, (float)shape.triangles / RSH_MEAN_RUN);
    rsh_part_in part;
    part.row.count = part.clusters = part.cut = 0;
    part.first_cluster = me * shape.part_clusters;
    part.next = me * shape.part;
    part.end = min(part.next + shape.part, shape.triangles);
    rsh_level_in level;
    level.row.count = 0;
    level.next_group = me * shape.part_groups;
    __global rsh_loose_box* own = loose + level.next_group;
    uint groups = 0;
    while (part.next < part.end || part.row.count) {
        load_triangles(&part, mesh, vertices, indices, order, boxes);
        cut_triangles(&part, price);
        if (level.row.count + part.row.runs > RSH_WINDOW) {
            cut_row(&level.row, RSH_MEAN_RUN * price, false);
            groups += store_groups(&level, &shape, boxes, own + groups);
        }
        store_clusters(&part, boxes, &level);
    }
    cut_row(&level.row, RSH_MEAN_RUN * price, true);
    part_groups(&shape, boxes)[me] = groups + store_groups(&level, &shape, boxes, own + groups);
    clear_clusters(boxes + cluster_at(part.first_cluster + part.clusters),
                   shape.part_clusters - part.clusters);
}

/* Loose boxes in their order: those of the parts, then those of the level made of them. */
typedef struct rsh_loose_in {
    __global rsh_loose_box* boxes;
    __global const uint* counts; /* groups of the parts; 0: there are no parts */
    uint part, next, end, left;
} rsh_loose_in;

static rsh_loose_in loose_of_parts(const rsh_scene_shape* shape, __global rsh_loose_box* loose,
                                   __global const uint* counts)
{
    rsh_loose_in in = {loose, counts, 0, 0, counts[0], 0};
    for (uint part = 0; part < shape->parts; ++part) in.left += counts[part];
    return in;
}

static rsh_loose_box take_loose(rsh_loose_in* in, const rsh_scene_shape* shape)
{
    while (in->next == in->end) {
        in->next = ++in->part * shape->part_groups;
        in->end = in->next + in->counts[in->part];
    }
    --in->left;
    return in->boxes[in->next++];
}

/* Returns the number of groups; their boxes take the places of those that are in them now. */
static uint bound_level(rsh_loose_in* in, float price, const rsh_scene_shape* shape,
                        rsh_level_in* level, __global float* boxes)
{
    const bool is_one = in->left <= 16;
    uint made = 0;
    level->row.count = 0;
    while (in->left || level->row.count) {
        while (in->left && level->row.count < RSH_WINDOW) {
            const rsh_loose_box box = take_loose(in, shape);
            add_box(level, box.side, box.below);
        }
        if (is_one)
            cut_evenly(&level->row, true);
        else
            cut_row(&level->row, price, !in->left);
        made += store_groups(level, shape, boxes, in->boxes + made);
    }
    return made;
}

/* Groups of groups, level by level; one work-item: there are 200 times fewer than triangles. */
__kernel void rsh_bound_groups(rsh_scene_shape scene_shape,
                               __global const rsh_sorting* sorting, uint span_count,
                               __global const rsh_span* spans, __global float* boxes,
                               __global rsh_loose_box* loose)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const rsh_scene_shape shape = scene_shape;
    const rsh_span scene = whole_span(spans, span_count);
    float price = RSH_MEAN_RUN * price_of(&scene, (float)shape.triangles / RSH_MEAN_RUN);
    rsh_level_in level;
    level.next_group = shape.parts * shape.part_groups;
    rsh_scene_top top = {0, 1, shape.triangles};
    rsh_loose_in in = loose_of_parts(&shape, loose, part_groups(&shape, boxes));
    while (in.left > 1) {
        price *= RSH_MEAN_RUN;
        const uint made = bound_level(&in, price, &shape, &level, boxes);
        top.group = level.next_group - 1;
        ++top.level;
        in = (rsh_loose_in){loose, 0, 0, 0, made, made};
    }
    *scene_top(&shape, boxes) = top;
}
