/* wave.cl - from one wave of rays to the next one, and back. The next wave holds the reflected
 * rays of all hits, then the refracted ones, packed: those of a screen in the order of
 * shade/screen_order.h, those of a packed wave in its own.
 *   rays, hits, weights  in   a wave; weights NULL: all 1
 *   branches             out  of each ray, where those that it sends on stand in the next wave:
 *                             reflected, refracted; RSH_NO_RAY: none
 *   list_count           in   how many of the part's rays there are; NULL: all
 *   counts               of each work-item, the rays of either kind; then (reduce/scan_counts.cl)
 *                        where they begin
 * A work-item has a range of places, see rays_at_places.
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "shade/branch.h"
#include "shade/screen_order.h"

/* Rays that wait until a block is full of them: where few of a screen are sent on, no lane idles. */
typedef struct waiting_rays {
    uint index[2 * RSH_WIDTH];
    uint count;
} waiting_rays;

/* The first RSH_WIDTH of them; RSH_NO_RAY: where there are not as many. */
RSH_CALLED static void take_block(waiting_rays* waiting, uint* index)
{
    const uint taken = min(waiting->count, (uint)RSH_WIDTH);
    for (uint k = 0; k < RSH_WIDTH; ++k) index[k] = k < taken ? waiting->index[k] : RSH_NO_RAY;
    waiting->count -= taken;
    for (uint k = 0; k < waiting->count; ++k) waiting->index[k] = waiting->index[taken + k];
}

/* Of RSH_WIDTH rays, those that may be sent on wait; of the others it is noted that none is. */
RSH_CALLED static void note_candidates(const surface_buffers* buffers,
                                       __global const rsh_material* materials, uint kinds,
                                       __global const rsh_hit* hits, const uint* index,
                                       waiting_rays* waiting, __global uint2* branches)
{
    uint primitive[RSH_WIDTH];
    for (uint k = 0; k < RSH_WIDTH; ++k)
        primitive[k] = index[k] == RSH_NO_RAY ? RSH_NO_HIT : hits[index[k]].primitive;
    const uint bits = candidate_lanes(buffers, materials, kinds, primitive);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        if (bits >> k & 1)
            waiting->index[waiting->count++] = index[k];
        else if (index[k] != RSH_NO_RAY)
            branches[index[k]] = (uint2)(RSH_NO_RAY);
    }
}

/* Numbers the rays that a block sends on, of either kind. */
RSH_CALLED static void number_branches(const branch_lanes* at, const uint* index, uint* sum,
                                       __global uint2* branches)
{
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        if (index[k] == RSH_NO_RAY) continue;
        uint2 branch = (uint2)(RSH_NO_RAY);
        if (at->bits[RSH_REFLECTED] >> k & 1) branch.x = sum[RSH_REFLECTED]++;
        if (at->bits[RSH_REFRACTED] >> k & 1) branch.y = sum[RSH_REFRACTED]++;
        branches[index[k]] = branch;
    }
}

/* Those among RSH_WIDTH rays that send others on wait. */
RSH_CALLED static void note_senders(__global const uint2* branches, const uint* index,
                                    waiting_rays* waiting)
{
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        if (index[k] == RSH_NO_RAY) continue;
        const uint2 branch = branches[index[k]];
        if (branch.x != RSH_NO_RAY || branch.y != RSH_NO_RAY)
            waiting->index[waiting->count++] = index[k];
    }
}

/* Where the rays that a block sends on stand in the next wave: counted from `begin` now. */
RSH_CALLED static void place_branches(const branch_lanes* at, const uint* index, uint2 begin,
                                      uint (*places)[RSH_WIDTH], __global uint2* branches)
{
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        places[RSH_REFLECTED][k] = places[RSH_REFRACTED][k] = RSH_NO_RAY;
        if (index[k] == RSH_NO_RAY) continue;
        uint2 branch = branches[index[k]];
        if (at->bits[RSH_REFLECTED] >> k & 1) branch.x += begin.x;
        if (at->bits[RSH_REFRACTED] >> k & 1) branch.y += begin.y;
        branches[index[k]] = branch;
        places[RSH_REFLECTED][k] = branch.x;
        places[RSH_REFRACTED][k] = branch.y;
    }
}

typedef struct next_wave {
    __global rsh_ray* rays;
    __global float4* weights;
    __global uint* skip;
} next_wave;

/* Writes the rays that a block sends on. */
RSH_CALLED static void send_block(const branch_lanes* at, const ray_lanes* block,
                                  const uint* index, uint2 begin, const next_wave* next,
                                  __global uint2* branches)
{
    uint places[RSH_BRANCHES][RSH_WIDTH];
    place_branches(at, index, begin, places, branches);
    const departure_lanes from = departures_of(&at->surface, block);
    for (uint kind = 0; kind < RSH_BRANCHES; ++kind) {
        if (at->bits[kind] == 0) continue;
        const sent_rays sent = send_branches(at, &from, kind, true);
        store_sent_rays(&sent, places[kind], block->primitive, next->rays, next->skip);
        store_sent_weights(at->weight[kind], sent.bits, places[kind], next->weights);
    }
}

/* Launched twice: with is_counting it counts the rays that are sent on; then, where the counts say, it
 * writes them. One kernel, as both look at the same hits in the same way.
 *   capacity    room in the next wave. If it has more rays, spawned_counts[bounce] of them, none is
 *               written.
 *   next_count  out  how many are
 */
RSH_FILLS_VECTORS
__kernel void rsh_wave_spawn(mesh_view mesh, __global const float* vertices,
                             __global const uint* indices, __global const float* normals,
                             __global const uint* material_ids,
                             __global const rsh_material* materials, uint material_count,
                             wave_part part, __global const uint* list_count, uint kinds,
                             float min_weight, __global const rsh_ray* rays,
                             __global const rsh_hit* hits, __global const float4* weights,
                             __global uint2* branches, __global uint* counts, uint is_counting,
                             uint capacity, __global const uint* spawned_counts, uint bounce,
                             __global uint* next_count, __global rsh_ray* spawned_rays,
                             __global float4* spawned_weights, __global uint* spawned_skip)
{
    const uint me = get_global_id(0), items = get_global_size(0);
    const uint total = is_counting ? 0 : spawned_counts[bounce];
    if (me == 0 && !is_counting) *next_count = total > capacity ? 0 : total;
    if (total > capacity) return;
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const next_wave next = {spawned_rays, spawned_weights, spawned_skip};
    const uint2 begin = is_counting ? (uint2)(0) : (uint2)(counts[me], counts[items + me]);
    const strided_range mine = my_range(counted_rays(part.count, list_count));
    uint sum[RSH_BRANCHES] = {0, 0}, place = mine.begin;
    waiting_rays waiting;
    waiting.count = 0;
    for (;;) {
        uint index[RSH_WIDTH];
        for (; place < mine.end && waiting.count < RSH_WIDTH; place += RSH_WIDTH) {
            rays_at_places(part, part.first + place, part.first + mine.end, index);
            if (is_counting)
                note_candidates(&buffers, materials, kinds, hits, index, &waiting, branches);
            else
                note_senders(branches, index, &waiting);
        }
        if (waiting.count == 0) break;
        ray_lanes block;
        branch_lanes at;
        take_block(&waiting, index);
        load_rays(index, rays, hits, &block);
        const uint bits =
            find_branches(&buffers, materials, kinds, load_weights(index, weights), min_weight,
                          &block, RSH_LANE_BITS(block.is_active), &at);
        if (is_counting)
            number_branches(&at, index, sum, branches);
        else if (bits)
            send_block(&at, &block, index, begin, &next, branches);
    }
    if (!is_counting) return;
    counts[me] = sum[RSH_REFLECTED];
    counts[items + me] = sum[RSH_REFRACTED];
}

RSH_CALLED static void gather_block(const uint* index, __global const uint2* branches,
                                    __global const float4* next, __global float4* colour)
{
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const uint i = index[k];
        if (i == RSH_NO_RAY) continue;
        const uint2 branch = branches[i];
        if (branch.x != RSH_NO_RAY) colour[i].xyz += next[branch.x].xyz;
        if (branch.y != RSH_NO_RAY) colour[i].xyz += next[branch.y].xyz;
    }
}

/* Adds to the colour of each ray what those see that it sent on: reflected, then refracted, so
 * that the sum does not depend on how a wave is split up.
 *   next_count  in  0: it has none; NULL: some
 *   next        in  colours of the next wave
 */
RSH_FILLS_VECTORS
__kernel void rsh_wave_gather(wave_part part, __global const uint* list_count,
                              __global const uint2* branches, __global const uint* next_count,
                              __global const float4* next, __global float4* colour)
{
    if (next_count && *next_count == 0) return;
    const strided_range mine = my_range(counted_rays(part.count, list_count));
    for (uint place = mine.begin; place < mine.end; place += RSH_WIDTH) {
        uint index[RSH_WIDTH];
        rays_at_places(part, part.first + place, part.first + mine.end, index);
        gather_block(index, branches, next, colour);
    }
}
