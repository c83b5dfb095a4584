/* traverse_ranges.cl - one level of the engine `paper`: the triangles in a node's range against
 * its 16 children, all at a time. They are counted first and written second: no pair that fails
 * is ever written, and what does not fit is known before.
 *   triangles, ranges  in   of the parents
 *   list_count         in   how many rays of a list there are; NULL: all
 *   masks              out  per triangle, which children it meets
 *   counts             out  per slice and child
 *   sums               out  per slice; reduce/scan_counts.cl scans them in between
 *   children, ranges   out  the stream of the level, parent by parent, child by child
 *   tally              out  what statistics need; see RSH_TALLY_...
 * A work-item takes a slice of a parent's range. Does not look at rays.
 */
#include "rays/nodes_head.h"
#include "traverse/paper/ranges.h"
#include "traverse/paper/siblings.h"
#include "traverse/wrong_buffers.h"

#define RSH_CHILDREN ((uint16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))

/* groups: from word first_word of `groups` on. At the root the traversal ends where bounds or
 * nodes are not its own: no triangle meets anything. */
RSH_FILLS_VECTORS
__kernel void rsh_traverse_ranges_count(
    range_step given, bvh_whole scene_shape, ray_levels shape, __global const uint* list_count,
    __global const float* bounds, __global const float* nodes, __global const float* groups,
    uint first_word, volatile __global uint* wrong, __global const uint* triangles,
    __global const uint2* ranges, __global ushort* masks, __global uint* counts,
    __global uint* sums)
{
    const uint me = get_global_id(0);
    const ray_levels levels = counted_levels(shape, list_count);
    const range_step step = counted_step(given, &levels, list_count);
    if (me >= step.parents * step.slices) return; /* launch is rounded up to whole groups */
    const uint parent = me / step.slices;
    const triangle_range slice =
        slice_of(range_of_parent(step, ranges, parent), me % step.slices, step.slices);
    uint16 count = (uint16)(0);
    const bool is_right =
        !step.is_root ||
        are_right(are_made_of(bounds, scene_shape),
                  nodes_are_of(shape, levels.width[0], RSH_BOXES_MADE, nodes), wrong);
    if (slice.count > 0) {
        sibling_nodes siblings;
        load_siblings(
            &siblings,
            groups + first_word + (ulong)RSH_GROUP_FLOATS * (step.first_child_group + parent));
        for (uint i = slice.begin; i < slice.begin + slice.count; ++i) {
            const uint triangle = triangle_at(step, triangles, i);
            const uint met = is_right ? siblings_meeting(&siblings, bounds, triangle) : 0;
            masks[i] = (ushort)met;
            count += ((uint16)(met) >> RSH_CHILDREN) & (uint16)(1);
        }
    }
    vstore16(count, me, counts);
    const uint8 a = count.lo + count.hi;
    const uint4 b = a.lo + a.hi;
    sums[me] = b.x + b.y + b.z + b.w;
}

/* Where the triangles of each child go: child by child, and there slice by slice. total: of all
 * slices. */
static void place_children(range_step step, __global const uint* counts, uint me, uint begin,
                           uint* at, uint* total)
{
    const uint slice = me % step.slices, first = me - slice;
    uint16 before = (uint16)(0), all = (uint16)(0);
    for (uint p = 0; p < step.slices; ++p) {
        const uint16 count = vload16(first + p, counts);
        if (p < slice) before += count;
        all += count;
    }
    vstore16(before, 0, at);
    vstore16(all, 0, total);
    for (uint k = 0; k < 16; ++k) {
        at[k] += begin;
        begin += total[k];
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_traverse_ranges_emit(ray_levels shape, __global const uint* list_count,
                                       range_step given, __global const uint* triangles,
                                       __global const ushort* masks,
                                       __global const uint* counts, __global const uint* sums,
                                       __global uint* children, __global uint2* ranges,
                                       __global uint* tally)
{
    const uint me = get_global_id(0);
    const ray_levels levels = counted_levels(shape, list_count);
    const range_step step = counted_step(given, &levels, list_count);
    if (me >= step.parents * step.slices) return;
    const uint parent = me / step.slices;
    const triangle_range slice =
        slice_of(range_of_parent(step, ranges, parent), me % step.slices, step.slices);
    const bool fits = !is_left_over(step, sums, parent);
    uint at[16], total[16];
    place_children(step, counts, me, survivors_before(step, sums, parent), at, total);
    if (me % step.slices == 0) {
        for (uint k = 0; k < 16; ++k) {
            const uint child = child_of(&levels, step.level, parent, k);
            if (child != RSH_NO_NODE)
                ranges[step.first_child_range + child] = (uint2)(at[k], fits ? total[k] : 0);
        }
        if (fits && step.is_counting)
            atomic_max(tally + step.level, survivors_before(step, sums, parent + 1));
        if (parent == 0 && step.is_counting)
            tally[RSH_TALLY_SURVIVORS + step.level] =
                survivors_before(step, sums, step.parents);
        if (step.is_root && step.is_counting) tally[RSH_TALLY_ROOT] = step.level + 1;
    }
    for (uint i = slice.begin; fits && i < slice.begin + slice.count; ++i) {
        const uint triangle = triangle_at(step, triangles, i);
        for (uint met = masks[i]; met; met &= met - 1)
            children[at[31 - clz(met & -met)]++] = triangle;
    }
}
