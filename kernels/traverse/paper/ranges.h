/* ranges.h - the pair stream of the engine `paper`: per node a range of triangles, so that a
 * pair takes 4 bytes and a node is loaded once for all its triangles.
 */
#ifndef RSH_TRAVERSE_PAPER_RANGES_H
#define RSH_TRAVERSE_PAPER_RANGES_H

#include "rays/levels.h"
#include "traverse/paper/types.h"

typedef struct triangle_range {
    uint begin, count; /* in the stream of its level */
} triangle_range;

/* The step of those rays of a list that there are: the work-items of all parents share the parents
 * of these rays; above their root there are none. */
static range_step counted_step(range_step step, const ray_levels* counted,
                               __global const uint* list_count)
{
    if (!list_count) return step;
    const uint items = step.parents * step.slices;
    step.is_root = step.level + 1 == counted->count;
    step.parents = step.level + 1 > counted->count ? 0 : counted->width[step.level + 1];
    step.slices = clamp(items / max(step.parents, 1u), 1u, (uint)RSH_MAX_SLICES);
    return step;
}

/* The triangles that are paired with a parent; at the root, the whole batch. */
static triangle_range range_of_parent(range_step step, __global const uint2* ranges,
                                      uint parent)
{
    if (step.is_root) return (triangle_range){0, step.batch_count};
    const uint2 range = ranges[step.first_parent_range + parent];
    return (triangle_range){range.x, range.y};
}

/* A work-item's share of a range: slice `number` of `slices`. */
static triangle_range slice_of(triangle_range range, uint number, uint slices)
{
    const uint begin = (uint)((ulong)range.count * number / slices);
    const uint end = (uint)((ulong)range.count * (number + 1) / slices);
    return (triangle_range){range.begin + begin, end - begin};
}

static uint triangle_at(range_step step, __global const uint* triangles, uint i)
{
    return step.is_root ? step.batch_first + i : triangles[i];
}

/* Where the survivors of a parent begin. sums: per slice, how many survivors there are before
 * it; behind the last slice, how many there are. What follows means nothing. */
static uint survivors_before(range_step step, __global const uint* sums, uint parent)
{
    return sums[parent * step.slices];
}

/* Whether the stream cannot hold the survivors of this parent, if there is such a one. Then
 * rsh_intersect_ranges_finish works its range off. Known before anything is written. */
static bool is_left_over(range_step step, __global const uint* sums, uint parent)
{
    return parent < step.parents && survivors_before(step, sums, parent + 1) > step.capacity;
}

#endif
