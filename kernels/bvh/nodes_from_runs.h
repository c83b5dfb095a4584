/* nodes_from_runs.h - groups of 16 boxes as clusters are made of triangles: runs of 8 and more in
 * their order along the curve, and runs of these, up to one. A tenth of the work that the tree
 * of bvh/binary_tree.h is; rays alone open more of them. Groups get their numbers from the first on,
 * so that those in them come before.
 */
#ifndef RSH_BVH_NODES_FROM_RUNS_H
#define RSH_BVH_NODES_FROM_RUNS_H

#include "bvh/leaf_cuts.h"
#include "bvh/leaves.h"

/* Boxes of a level on their way into groups, and where these go. */
typedef struct rsh_level_in {
    rsh_row row;
    uint below[RSH_WINDOW + 16];
    float price;     /* of a group */
    uint next_group; /* number */
} rsh_level_in;

static void store_group(const rsh_level_in* level, uint first, uint length,
                        __global float* group)
{
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const intv is_there = RSH_LANES + (int)(RSH_WIDTH * v) < (intv)((int)length);
#pragma unroll
        for (uint f = 0; f < 6; ++f)
            store_lanes(
                select((floatv)(no_side(f)),
                       load_lanes(level->row.side[f] + first + RSH_WIDTH * v), is_there),
                group + 16 * f + RSH_WIDTH * v);
        store_lanes(
            select((uintv)(RSH_NO_BOX), load_lanes(level->below + first + RSH_WIDTH * v),
                   as_uintv(is_there)),
            (__global uint*)group + RSH_BELOW_AT + RSH_WIDTH * v);
    }
}

/* Stores the runs of the row as groups, and the boxes around them in `loose`. */
static void store_groups(rsh_level_in* level, const rsh_scene_shape* shape,
                         __global float* boxes, __global rsh_loose_box* loose)
{
    uint first = 0;
    for (uint r = 0; r < level->row.runs; ++r) {
        const uint length = level->row.run[r], group = level->next_group++;
        store_group(level, first, length, boxes + box_group_at(shape, group));
        rsh_loose_box around;
        bound_run(&level->row, first, length, around.side);
        around.below = group;
        loose[RSH_CLUSTERS(*shape) + group] = around;
        first += length;
    }
    shift_row(&level->row, first);
    shift_words((float*)level->below, first, level->row.count);
}

/* The boxes first .. end - 1 of `loose` are next; some of them wait in the row. */
static void add_boxes_from(rsh_level_in* level, uint first, uint end,
                           const rsh_scene_shape* shape, __global float* boxes,
                           __global rsh_loose_box* loose)
{
    for (uint i = first; i < end; ++i) {
        if (level->row.count == RSH_WINDOW) {
            cut_row(&level->row, level->price, false);
            store_groups(level, shape, boxes, loose);
        }
        const uint at = level->row.count++;
        for (uint f = 0; f < 6; ++f) level->row.side[f][at] = loose[i].side[f];
        level->below[at] = loose[i].below;
    }
}

/* A level that fits into one group does not become two. */
static void end_level(rsh_level_in* level, bool is_top, const rsh_scene_shape* shape,
                      __global float* boxes, __global rsh_loose_box* loose)
{
    if (is_top && level->row.count <= 16)
        cut_evenly(&level->row, true);
    else
        cut_row(&level->row, level->price, true);
    store_groups(level, shape, boxes, loose);
}

static void begin_levels(rsh_level_in* level, float price, uint first_group)
{
    level->row.count = 0;
    level->price = fmin(price, RSH_MOST_SURFACE);
    level->next_group = first_group;
}

/* Groups of the clusters of a part. */
static rsh_group_range group_part(const rsh_scene_shape* shape, float price, uint part,
                                  uint clusters, __global float* boxes,
                                  __global rsh_loose_box* loose)
{
    const uint first = part * shape->part_clusters;
    rsh_group_range made = {part * shape->part_groups, 0};
    rsh_level_in level;
    begin_levels(&level, price, made.first);
    add_boxes_from(&level, first, first + clusters, shape, boxes, loose);
    end_level(&level, false, shape, boxes, loose);
    made.end = level.next_group;
    return made;
}

/* Groups of the parts' groups, level by level. */
static rsh_group_range group_levels(const rsh_scene_shape* shape, float price,
                                    __global float* boxes, __global rsh_loose_box* loose)
{
    rsh_group_range made = {first_upper_group(shape), 0};
    rsh_level_in level;
    begin_levels(&level, price, made.first);
    const uint groups_at = RSH_CLUSTERS(*shape);
    for (uint p = 0; p < shape->parts; ++p) {
        const rsh_group_range of = part_counts(shape, boxes)[p].groups;
        add_boxes_from(&level, groups_at + of.first, groups_at + of.end, shape, boxes, loose);
    }
    end_level(&level, true, shape, boxes, loose);
    for (uint first = made.first; level.next_group - first > 1;) {
        const uint end = level.next_group;
        level.price = fmin(RSH_MEAN_RUN * level.price, RSH_MOST_SURFACE);
        add_boxes_from(&level, groups_at + first, groups_at + end, shape, boxes, loose);
        end_level(&level, true, shape, boxes, loose);
        first = end;
    }
    made.end = level.next_group;
    return made;
}

#endif
