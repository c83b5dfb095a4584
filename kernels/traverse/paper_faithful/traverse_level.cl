/* traverse_level.cl - one level of the traversal: tests each pair against the node's four
 * children.
 *   pairs, counts  in   survivors of the level above; at the root none are stored, there every
 *                       triangle of the batch is one
 *   list_count     in   how many rays of a list there are; NULL: all
 *   tested_pairs   out  4 per pair: (triangle, child), or NULL if they cannot meet
 *   tested_count   out  how many, NULLs included
 * Tests at most `limit` pairs: traverse_walk.cl finishes the others. Packing the survivors is
 * the reduction's job. A work-item tests RSH_PAIRS pairs at once: their quads fill a vector.
 */
#include "lanes/stride.h"
#include "traverse/paper_faithful/test_pairs.h"
#include "traverse/wrong_buffers.h"

static void write_children(const ray_levels* levels, uint level, stream_pair pair,
                           const int* survives, ulong at, __global uint* tested_pairs)
{
    const uint4 triangle =
        select((uint4)(RSH_NO_HIT), (uint4)(pair.triangle), as_uint4(vload4(0, survives)));
    const uint4 node = child_names(levels, level, pair.node);
    vstore8(
        (uint8)(triangle.x, node.x, triangle.y, node.y, triangle.z, node.z, triangle.w, node.w),
        at, tested_pairs);
}

/* Pairs first .. first + count - 1, at most RSH_PAIRS of them; the last one fills up the
 * vector. */
static void test_group(const ray_levels* levels, uint level, const stream_pair* pairs,
                       uint first, uint count, __global const float4* bounds,
                       __global const uint* nodes, __global uint* tested_pairs)
{
    int survives[4 * RSH_PAIRS];
    test_pairs(levels, level, pairs, bounds, nodes, survives);
    for (uint i = 0; i < count; ++i)
        write_children(levels, level, pairs[i], survives + 4 * i, first + i, tested_pairs);
}

static uint group_count(uint count) { return count / RSH_PAIRS + (count % RSH_PAIRS != 0); }

/* Pairs that nobody stored: (batch_first + i, root), none above the root or without rays. Their number
 * is told in `counts`, as the reductions tell that of the others. */
static uint pairs_with_root(const ray_levels* counted, uint level, uint batch_count,
                            __global uint* counts)
{
    const bool is_root = level + 1 == counted->count && counted->width[0] > 0;
    if (get_global_id(0) == 0) counts[level + 1] = is_root ? batch_count : 0;
    return is_root ? batch_count : 0;
}

/* None at all where bounds or nodes are not those of this traversal. */
__kernel void rsh_traverse_level(ray_levels shape, __global const uint* list_count, uint level,
                                 uint limit, uint batch_first, uint batch_count, uint triangles,
                                 __global const float4* bounds, __global const uint* nodes,
                                 __global const stream_pair* pairs, __global uint* counts,
                                 __global uint* tested_pairs, __global uint* tested_count,
                                 volatile __global uint* wrong)
{
    const ray_levels levels = shape; /* nodes are where the shape has them */
    const ray_levels counted = counted_levels(shape, list_count);
    const bool is_stored = level + 1 < counted.count;
    uint count = is_stored ? min(counts[level + 1], limit)
                           : pairs_with_root(&counted, level, batch_count, counts);
    if (count > 0 && !is_stored &&
        !are_right(spheres_are_of(triangles, bounds),
                   nodes_are_of(shape, counted.width[0], RSH_CONES_MADE, nodes), wrong))
        count = 0;
    if (get_global_id(0) == 0) *tested_count = 4 * count;
    const strided_range mine = my_elements(group_count(count));
    for (uint g = mine.begin; g < mine.end; g += mine.step) {
        const uint first = g * RSH_PAIRS;
        stream_pair group[RSH_PAIRS];
        for (uint i = 0; i < RSH_PAIRS; ++i) {
            const uint at = min(first + i, count - 1);
            group[i] = is_stored ? pairs[at] : (stream_pair){batch_first + at, 0};
        }
        test_group(&levels, level, group, first, min((uint)RSH_PAIRS, count - first), bounds,
                   nodes, tested_pairs);
    }
}
