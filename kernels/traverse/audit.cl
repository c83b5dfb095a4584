/* audit.cl - traces a sample of rays again by brute force and counts the answers that differ.
 *   rays, skip, hits, occlusion  in
 *   list_count             in      how many rays of ray_count there are; NULL: all
 *   report                 in/out  an rsh_audit_report, adds up
 * A work-item gathers rays, one from each of its ranges, and traces RSH_RAYS_PER_ITEM at once.
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "traverse/brute_force.h"
#include "traverse/count.h"

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

static bool differ(rsh_hit a, rsh_hit b)
{
    return as_uint(a.t) != as_uint(b.t) || as_uint(a.u) != as_uint(b.u) ||
           as_uint(a.v) != as_uint(b.v) || a.primitive != b.primitive;
}

/* Word of the report that counts what is wrong with an answer; 0: nothing is. */
static uint fault_of(rsh_hit answer, rsh_hit expected)
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

/* index: of RSH_RAYS_PER_ITEM rays, the first `count` of which there are. */
static void audit_rays(const triangles_left* left, const uint* index, uint count,
                       __global const rsh_hit* hits, __global const uint* occlusion,
                       uint occlusion_bit, __global uint* report)
{
    item_hits expected;
    hit_list none = hit_list_in(0, 0, 1);
    trace_by_force(left, index, &none, &expected);
    uint differences = 0, first_ray = RSH_NO_HIT;
    for (uint i = 0; i < count; ++i) {
        const uint ray = index[i];
        const uint fault = occlusion_bit
                               ? occlusion_fault_of((occlusion[ray] & occlusion_bit) != 0,
                                                    expected.primitive[i] != RSH_NO_HIT)
                               : fault_of(hits[ray], hit_at(&expected, i, left->rays[ray]));
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

__kernel void rsh_audit(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, __global const rsh_ray* rays,
                        __global const uint* skip, uint ray_count,
                        __global const uint* list_count, __global const rsh_hit* hits,
                        __global const uint* occlusion, uint occlusion_bit, uint sample,
                        uint seed, __global uint* report)
{
    const triangles_left left = {mesh, vertices, indices, rays, skip};
    const uint all = counted_rays(ray_count, list_count), ranges = min(sample, all);
    const strided_range mine = my_elements(ranges);
    uint index[RSH_RAYS_PER_ITEM], count = 0;
    for (uint range = mine.begin; range < mine.end || count > 0; range += mine.step) {
        const uint ray =
            range < mine.end ? pick_ray(rays, all, range, ranges, seed) : RSH_NO_RAY;
        if (ray != RSH_NO_RAY) index[count++] = ray;
        if (range < mine.end && count < RSH_RAYS_PER_ITEM) continue;
        for (uint i = count; i < RSH_RAYS_PER_ITEM; ++i) index[i] = RSH_NO_RAY;
        audit_rays(&left, index, count, hits, occlusion, occlusion_bit, report);
        count = 0;
    }
}
