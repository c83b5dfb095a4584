/* list_hits.cl - from the number of hits of each ray, and the hits as records in any order, to lists:
 * ray by ray, each ray's sorted by t, then by triangle.
 *   counts   in      hits per ray
 *   sums     in/out  of the counts of each work-item's range of rays
 *   offsets  out     where the hits of each ray begin; behind the last ray: how many there are
 *   records  in      and packed hits, see traverse/hit_list.h
 *   hits     out     written only if all of them fit
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "rays/nodes_head.h"
#include "rays/tile_layout.h"
#include "traverse/copy_hits.h"
#include "traverse/hit_list.h"
#include "traverse/hit_order.h"

__kernel void rsh_sum_hits(uint ray_count, __global const uint* counts, __global ulong* sums)
{
    const strided_range mine = my_range(ray_count);
    ulong sum = 0;
    for (uint i = mine.begin; i < mine.end; ++i) sum += counts[i];
    sums[get_global_id(0)] = sum;
}

/* As many work-items as in rsh_sum_hits, whose sums each adds up to where its own rays begin. */
__kernel void rsh_place_offsets(uint ray_count, __global const uint* counts,
                                __global const ulong* sums, __global ulong* offsets)
{
    const strided_range mine = my_range(ray_count);
    const uint me = get_global_id(0);
    ulong next = 0;
    for (uint i = 0; i < me; ++i) next += sums[i];
    for (uint i = mine.begin; i < mine.end; ++i) {
        offsets[i] = next;
        next += counts[i];
    }
    if (me == get_global_size(0) - 1) offsets[ray_count] = next;
}

__kernel void rsh_place_hits(uint ray_count, __global const ulong* offsets, ulong hit_capacity,
                             __global const hit_record* head, uint record_capacity,
                             __global rsh_hit* hits)
{
    if (offsets[ray_count] > hit_capacity) return;
    const uint used = ((__global const hit_records_head*)head)->used;
    __global const hit_record* records = head + 1;
    const strided_range mine = my_elements(min(used, record_capacity));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const hit_record record = records[i];
        if (record.ray != RSH_NO_HIT) hits[offsets[record.ray] + record.rank] = record.hit;
    }
}

RSH_DEFINE_COPY_HITS(copy_hits, __global)

/* A work-item moves the hits that a tile has packed; those of neighbouring rays at once. */
__kernel void rsh_place_packed(ray_levels shape, __global const uint* list_count,
                               uint ray_count, __global const float* nodes,
                               __global const uint* counts, __global const ulong* offsets,
                               ulong hit_capacity, __global const hit_record* head,
                               uint record_capacity, __global rsh_hit* hits)
{
    const ray_levels levels = counted_levels(shape, list_count);
    const uint me = my_element(tile_count(levels));
    if (me == tile_count(levels) || offsets[ray_count] > hit_capacity) return;
    const uint end = *packed_end_of(head + 1, record_capacity, me);
    if (end == 0) return;
    __global const float4* from =
        (__global const float4*)packed_at(head + 1, record_capacity, end);
    const ray_tile tile = tile_at(levels, order_in(nodes), me);
    ulong to = 0;
    uint count = 0;
    for (uint k = 0; k < 256; ++k) {
        const uint ray = ray_of(tile, k / 16, k % 16);
        if (ray == RSH_NO_RAY) continue;
        if (offsets[ray] != to + count) {
            copy_hits(from, count, hit_capacity, hits + to);
            from += count;
            to = offsets[ray];
            count = 0;
        }
        count += min(counts[ray], (uint)RSH_HIT_ROWS);
    }
    copy_hits(from, count, hit_capacity, hits + to);
}

static void insert_in_order(__global rsh_hit* hits, uint count)
{
    for (uint i = 1; i < count; ++i) {
        const rsh_hit hit = hits[i];
        uint at = i;
        for (; at > 0 && comes_before(hit, hits[at - 1]); --at) hits[at] = hits[at - 1];
        hits[at] = hit;
    }
}

/* Lets a hit sink in a heap, whose parents come after their children, from the empty place `at`. */
static void sink_in_heap(__global rsh_hit* hits, uint count, uint at, rsh_hit hit)
{
    for (uint child; (child = 2 * at + 1) < count; at = child) {
        if (child + 1 < count && comes_before(hits[child], hits[child + 1])) ++child;
        if (!comes_before(hit, hits[child])) break;
        hits[at] = hits[child];
    }
    hits[at] = hit;
}

static void sort_by_heap(__global rsh_hit* hits, uint count)
{
    for (uint i = count / 2; i-- > 0;) sink_in_heap(hits, count, i, hits[i]);
    for (uint left = count - 1; left > 0; --left) {
        const rsh_hit last = hits[left];
        hits[left] = hits[0];
        sink_in_heap(hits, left, 0, last);
    }
}

/* Hits up to which inserting them one by one is quicker. */
#define RSH_FEW_HITS 32

/* sorted: how many hits a ray may have whose list is in order already. */
__kernel void rsh_sort_hits(uint ray_count, __global const ulong* offsets, ulong hit_capacity,
                            __global const hit_record* head, uint sorted,
                            __global rsh_hit* hits)
{
    if (((__global const hit_records_head*)head)->used == 0) return; /* all are in order */
    if (offsets[ray_count] > hit_capacity) return;
    const strided_range mine = my_elements(ray_count);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const ulong begin = offsets[i];
        const uint count = (uint)(offsets[i + 1] - begin);
        if (count <= sorted) continue;
        if (count <= RSH_FEW_HITS)
            insert_in_order(hits + begin, count);
        else
            sort_by_heap(hits + begin, count);
    }
}
