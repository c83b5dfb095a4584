/* scan.h - prefix sum over a work-group.
 *   sums  local, one uint per work-item; holds the inclusive sums afterwards
 */
#ifndef RSH_REDUCE_SCAN_H
#define RSH_REDUCE_SCAN_H

/* Inclusive prefix sum over the group (Hillis and Steele 1986), log2(group) steps. */
static uint scan_group(uint value, __local uint* sums)
{
    const uint me = get_local_id(0), size = get_local_size(0);
    sums[me] = value;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint step = 1; step < size; step *= 2) {
        const uint left = me >= step ? sums[me - step] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        sums[me] += left;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    return sums[me];
}

#endif
