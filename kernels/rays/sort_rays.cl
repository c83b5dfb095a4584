/* sort_rays.cl - keys for the order in which the rays of a list make blocks: by the octant of
 * their direction, then along Hilbert's curve by their origin.
 *   rays           in   a list with room for `width` of them
 *   list_count     in   how many there are; NULL: `width`
 *   sorting, keys  out  for order/sort.cl
 *   bins           out  how many rays are in each bin
 * Consecutive rays mostly are neighbours already, and stay as they are. In a queue that was
 * filled by many work-items they are not: each block would span the scene, and its rays go one
 * by one. A work-item has a range of the rays.
 *   samples, extents  out  of rsh_sort_rays_measure, in of rsh_sort_rays_keys: of each work-item, a box
 *                          and `sampled` of RSH_SAMPLES extents
 */
#include "order/hilbert.h"
#include "order/sort.h"
#include "rays/levels.h"
#include "rays/ray_block.h"
#include "tuning.h"

/* Work-items that share the rays, as the host counts them where it knows `count`. */
static uint items_of(uint count)
{
    return min((uint)get_global_size(0), (uint)RSH_SORT_ITEMS(count, RSH_RAY_BINS));
}

/* Group number `sixteen` of a list, as block 0 of a tile. */
static ray_tile list_of(uint count, uint sixteen)
{
    return (ray_tile){count, 0, 16 * sixteen, 0, 0};
}

/* Bounds of three rows of the active rays, from row `first` on: origins or directions. */
RSH_CALLED static sample_bounds bounds_of_rays(const ray_block* block, uint first)
{
    sample_bounds bounds = empty_bounds();
    for (uint axis = 0; axis < 3; ++axis) {
        floatv low[RSH_VECTORS], high[RSH_VECTORS];
        for_each_vector(v) {
            const floatv at = block->row[first + axis][v];
            low[v] = select((floatv)(INFINITY), at, block->is_active[v]);
            high[v] = select((floatv)(-INFINITY), at, block->is_active[v]);
        }
        bounds.low[axis] = smallest_lane(low);
        bounds.high[axis] = largest_lane(high);
    }
    return bounds;
}

static void add_bounds(sample_bounds* whole, const sample_bounds* part)
{
    for (uint axis = 0; axis < 3; ++axis) {
        whole->low[axis] = fmin(whole->low[axis], part->low[axis]);
        whole->high[axis] = fmax(whole->high[axis], part->high[axis]);
    }
}

static float share_of(uint converging)
{
    return converging ? RSH_CONVERGING_EXTENT : RSH_INCOHERENT_EXTENT;
}

static block_extent extent_of(const ray_block* block, const sample_bounds* origins, float share)
{
    const sample_bounds directions = bounds_of_rays(block, RSH_DIRECTION);
    float longest = 0.0f;
    for (uint axis = 0; axis < 3; ++axis)
        longest = fmax(longest, fmax(fabs(directions.low[axis]), fabs(directions.high[axis])));
    return (block_extent){longest_side(origins),
                          longest_side(&directions) > share * 2.0f * longest};
}

/* Blocks without active rays do not count. */
RSH_CALLED static sample_bounds sample_rays(__global const rsh_ray* rays, uint count,
                                            range16 mine, float share,
                                            __global block_extent* extents)
{
    sample_bounds bounds = empty_bounds();
    for (uint g = mine.begin; g < mine.end; g += sampling_step(mine)) {
        ray_block block;
        load_block(list_of(count, g), 0, rays, &block);
        if (!active_lanes(&block)) continue;
        const sample_bounds origins = bounds_of_rays(&block, 0);
        add_bounds(&bounds, &origins);
        extents[bounds.sampled++] = extent_of(&block, &origins, share);
    }
    return bounds;
}

RSH_FILLS_VECTORS
__kernel void rsh_sort_rays_measure(__global const rsh_ray* rays, uint width,
                                    __global const uint* list_count, uint converging,
                                    __global sample_bounds* samples,
                                    __global block_extent* extents)
{
    const uint me = get_global_id(0), count = counted_rays(width, list_count);
    samples[me] = sample_rays(rays, count, my_range16(count, items_of(count)),
                              share_of(converging), extents + RSH_SAMPLES * me);
}

/* Whether so many of the sampled blocks are incoherent that sorting pays. whole: the longest side of the
 * box around all origins. */
RSH_CALLED static bool rays_are_incoherent(__global const sample_bounds* samples,
                                           __global const block_extent* extents, uint items,
                                           float whole, float share)
{
    uint sampled = 0, incoherent = 0;
    for (uint i = 0; i < items; ++i) {
        sampled += samples[i].sampled;
        for (uint s = 0; s < samples[i].sampled; ++s) {
            const block_extent extent = extents[RSH_SAMPLES * i + s];
            incoherent += whole > 0.0f ? extent.origins > share * whole : extent.is_wide;
        }
    }
    return incoherent > RSH_INCOHERENT_RAYS(sampled);
}

RSH_CALLED static void keys_of_rays(const ray_block* block, const sample_bounds* whole,
                                    uint* keys)
{
    const float scale = cells_per_length(longest_side(whole), RSH_RAY_BITS);
    for (uint first = 0; first < RSH_VECTORS; first += RSH_ABREAST) {
        uintv cell[3][RSH_ABREAST], octant[RSH_ABREAST], place[RSH_ABREAST];
        for_each_abreast(v) {
            octant[v] = (uintv)(0u);
            for (uint axis = 0; axis < 3; ++axis) {
                const floatv d = block->row[RSH_DIRECTION + axis][first + v];
                cell[axis][v] =
                    cell_of(block->row[axis][first + v], whole->low[axis], scale, RSH_RAY_BITS);
                octant[v] |=
                    select((uintv)(0u), (uintv)(1u << axis), as_uintv(d < (floatv)(0.0f)));
            }
        }
        hilbert_places(cell[0], cell[1], cell[2], RSH_RAY_BITS, place);
        for_each_abreast(v) {
            const uintv key = octant[v] << (3 * RSH_RAY_BITS) | place[v];
            store_lanes(select((uintv)(8u << (3 * RSH_RAY_BITS)), key,
                               as_uintv(block->is_active[first + v])),
                        keys + RSH_WIDTH * (first + v));
        }
    }
}

RSH_CALLED static void write_keys_of_rays(__global const rsh_ray* rays, uint count,
                                          range16 mine, const sample_bounds* whole,
                                          uint bin_shift, __global uint* keys,
                                          __global uint* bins)
{
    for (uint b = 0; b < RSH_RAY_BINS; ++b) bins[b] = 0;
    for (uint g = mine.begin; g < mine.end; ++g) {
        ray_block block;
        uint key[16];
        load_block(list_of(count, g), 0, rays, &block);
        keys_of_rays(&block, whole, key);
        store_keys(key, g, count, bin_shift, keys, bins);
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_sort_rays_keys(__global const rsh_ray* rays, uint width,
                                 __global const uint* list_count, uint converging,
                                 __global const sample_bounds* samples,
                                 __global const block_extent* extents,
                                 __global sort_plan* sorting, __global uint* keys,
                                 __global uint* bins)
{
    const uint me = get_global_id(0), bin_shift = 3 * (RSH_RAY_BITS - RSH_RAY_CELL_BITS);
    const uint count = counted_rays(width, list_count), items = items_of(count);
    const sample_bounds whole = merged_bounds(samples, items);
    const bool is_needed = rays_are_incoherent(samples, extents, items, longest_side(&whole),
                                               share_of(converging));
    if (me == 0) *sorting = (sort_plan){is_needed, bin_shift, count, items};
    if (!is_needed || me >= items) return;
    write_keys_of_rays(rays, count, my_range16(count, items), &whole, bin_shift, keys,
                       bins + (ulong)RSH_RAY_BINS * me);
}
