/* audit.cl - traces a sample of rays again by brute force and counts the answers that differ.
 *   rays, skip, hits, occlusion  in
 *   hit_counts             in      count: how many hits each ray has
 *   hit_offsets            in      all: where those of each ray begin; ray_count + 1 of them
 *   hit_capacity           in      all: hits are there only if no more than that were found
 *   list_count             in      how many rays of ray_count there are; NULL: all
 *   report                 in/out  an rsh_audit_report, adds up
 * A work-item gathers rays, one from each of its ranges, and traces RSH_RAYS_PER_ITEM at once.
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "traverse/brute_force.h"
#include "traverse/count.h"
#include "traverse/hit_order.h"

/* Words of an rsh_audit_report. */
#define RSH_REPORT_RAYS 0
#define RSH_REPORT_DIFFERENCES 2
#define RSH_REPORT_FIRST_RAY 4
#define RSH_REPORT_MISSED 5
#define RSH_REPORT_SPURIOUS 6
#define RSH_REPORT_WRONG 7

/* MurmurHash3's last step (Appleby 2011): every bit of x changes about half of the bits. */
static uint scramble(uint x)
{
    x = (x ^ x >> 16) * 0x85ebca6bu;
    x = (x ^ x >> 13) * 0xc2b2ae35u;
    return x ^ x >> 16;
}

/* The first active ray of a range from a random place on, round its end; or RSH_NO_RAY. */
static uint pick_ray(__global const rsh_ray* rays, uint ray_count, uint range, uint sample,
                     uint seed)
{
    const uint begin = (uint)((ulong)ray_count * range / sample);
    const uint length = (uint)((ulong)ray_count * (range + 1) / sample) - begin;
    const uint start = scramble(range + scramble(seed)) % length;
    for (uint i = 0; i < length; ++i) {
        const uint ray = begin + (start + i) % length;
        if (is_active(rays[ray])) return ray;
    }
    return RSH_NO_RAY;
}

/* What the traversal answered. */
typedef struct given_answers {
    __global const rsh_ray* rays;
    __global const rsh_hit* hits;
    __global const uint* occlusion;
    uint occlusion_bit; /* as a mask; 0: closest hits */
    __global const uint* hit_counts;
    __global const ulong* hit_offsets;
    ulong hit_capacity;
    bool are_listed; /* all: the hits are there */
} given_answers;

#if RSH_ALL_HITS

/* Whether a list is in order and its digests have this sum. */
static bool is_list_of(__global const rsh_hit* hits, uint count, ulong sum)
{
    for (uint i = 0; i < count; ++i) {
        if (i > 0 && !comes_before(hits[i - 1], hits[i])) return false;
        sum -= digest_of(hits[i]);
    }
    return sum == 0;
}

/* Word of the report that counts what is wrong with the answer for the ray at place i; 0: nothing
 * is. */
static uint fault_of(const given_answers* given, const item_hits* expected, uint i, uint ray)
{
    const bool is_counted = given->hit_counts != 0;
    const ulong begin = is_counted ? 0 : given->hit_offsets[ray];
    const ulong count =
        is_counted ? given->hit_counts[ray] : given->hit_offsets[ray + 1] - begin;
    if (count != expected->count[i])
        return count < expected->count[i] ? RSH_REPORT_MISSED : RSH_REPORT_SPURIOUS;
    if (!given->are_listed) return 0;
    if (begin > given->hit_capacity || count > given->hit_capacity - begin)
        return RSH_REPORT_WRONG;
    return is_list_of(given->hits + begin, (uint)count, expected->sum[i]) ? 0
                                                                          : RSH_REPORT_WRONG;
}

#else

static bool differ(rsh_hit a, rsh_hit b)
{
    return as_uint(a.t) != as_uint(b.t) || as_uint(a.u) != as_uint(b.u) ||
           as_uint(a.v) != as_uint(b.v) || a.primitive != b.primitive;
}

static uint hit_fault_of(rsh_hit answer, rsh_hit expected)
{
    const bool is_hit = answer.primitive != RSH_NO_HIT;
    if (!differ(answer, expected)) return 0;
    if (expected.primitive == RSH_NO_HIT)
        return is_hit ? RSH_REPORT_SPURIOUS : RSH_REPORT_WRONG;
    if (!is_hit || answer.t > expected.t) return RSH_REPORT_MISSED;
    return answer.t == expected.t ? RSH_REPORT_WRONG : RSH_REPORT_SPURIOUS;
}

static uint occlusion_fault_of(bool answer, bool expected)
{
    return answer == expected ? 0 : expected ? RSH_REPORT_MISSED : RSH_REPORT_SPURIOUS;
}

/* Word of the report that counts what is wrong with the answer for the ray at place i; 0: nothing
 * is. */
static uint fault_of(const given_answers* given, const item_hits* expected, uint i, uint ray)
{
    if (given->occlusion_bit)
        return occlusion_fault_of((given->occlusion[ray] & given->occlusion_bit) != 0,
                                  expected->primitive[i] != RSH_NO_HIT);
    return hit_fault_of(given->hits[ray], hit_at(expected, i, given->rays[ray]));
}

#endif

/* index: of RSH_RAYS_PER_ITEM rays, the first `count` of which there are. */
static void audit_rays(const triangles_left* left, const given_answers* given,
                       const uint* index, uint count, __global uint* report)
{
    item_hits expected;
    hit_list none = hit_list_in(0, 0, 1);
    trace_by_force(left, index, &none, &expected);
    uint differences = 0, first_ray = RSH_NO_HIT;
    for (uint i = 0; i < count; ++i) {
        const uint ray = index[i], fault = fault_of(given, &expected, i, ray);
        if (fault == 0) continue;
        atomic_inc(report + fault);
        ++differences;
        first_ray = min(first_ray, ray);
    }
    add_to_count(report + RSH_REPORT_RAYS, count);
    if (differences == 0) return;
    add_to_count(report + RSH_REPORT_DIFFERENCES, differences);
    atomic_min(report + RSH_REPORT_FIRST_RAY, first_ray);
}

RSH_FILLS_VECTORS
__kernel void rsh_audit(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, __global const rsh_ray* rays,
                        __global const uint* skip, uint ray_count,
                        __global const uint* list_count, __global const rsh_hit* hits,
                        __global const uint* occlusion, uint occlusion_bit,
                        __global const uint* hit_counts, __global const ulong* hit_offsets,
                        ulong hit_capacity, uint sample, uint seed,
                        __global uint* report RSH_FILTER_PARAMETERS)
{
    const triangles_left left = {mesh, vertices, indices, rays, skip RSH_GIVEN_FILTER};
    const given_answers given = {
        rays,         hits,
        occlusion,    occlusion_bit,
        hit_counts,   hit_offsets,
        hit_capacity, hit_offsets && hit_offsets[ray_count] <= hit_capacity};
    const uint all = counted_rays(ray_count, list_count), ranges = min(sample, all);
    const strided_range mine = my_elements(ranges);
    uint index[RSH_RAYS_PER_ITEM], count = 0;
    for (uint range = mine.begin; range < mine.end || count > 0; range += mine.step) {
        const uint ray =
            range < mine.end ? pick_ray(rays, all, range, ranges, seed) : RSH_NO_RAY;
        if (ray != RSH_NO_RAY) index[count++] = ray;
        if (range < mine.end && count < RSH_RAYS_PER_ITEM) continue;
        for (uint i = count; i < RSH_RAYS_PER_ITEM; ++i) index[i] = RSH_NO_RAY;
        audit_rays(&left, &given, index, count, report);
        count = 0;
    }
}
