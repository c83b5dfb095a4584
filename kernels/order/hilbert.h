/* hilbert.h - places along Hilbert's curve through a grid of cells, a point per lane.
 * Consecutive cells share a face, so that ranges along the curve are compact; along Morton's
 * curve, which jumps, 1.5 to 2 times as many rays meet their boxes.
 *
 * Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707, 2004.
 */
#ifndef RSH_ORDER_HILBERT_H
#define RSH_ORDER_HILBERT_H

#include "lanes/lanes.h"

/* Spreads the lower 7 bits: bit i goes to bit 3 i. */
static uintv spread_bits(uintv x)
{
    x = (x | x << 8) & 0x00700fu;
    x = (x | x << 4) & 0x0430c3u;
    return (x | x << 2) & 0x049249u;
}

/* All ones where the bit is set. */
static uintv mask_of(uintv x, uint bit) { return (uintv)(0u) - (x >> bit & 1u); }

/* In the bits below `bit`: inverts x where b has the bit set, swaps x and b where not. */
static void turn(uintv* x, uintv* b, uint bit)
{
    const uint lower_bits = (1u << bit) - 1;
    const uintv is_set = mask_of(*b, bit);
    const uintv swapped = (*x ^ *b) & ~is_set & lower_bits;
    *x ^= swapped | (is_set & lower_bits);
    *b ^= swapped;
}

/* cell: x, y, z, each below 2^bits; bits is 7 at most. */
static uintv hilbert_place(const uintv cell[3], uint bits)
{
    uintv x = cell[0], y = cell[1], z = cell[2];
    for (uint bit = bits - 1; bit > 0; --bit) {
        const uint lower_bits = (1u << bit) - 1;
        x ^= mask_of(x, bit) & lower_bits;
        turn(&x, &y, bit);
        turn(&x, &z, bit);
    }
    y ^= x;
    z ^= y;
    uintv flip = (uintv)(0u);
    for (uint bit = bits - 1; bit > 0; --bit) flip ^= mask_of(z, bit) & ((1u << bit) - 1);
    return spread_bits(x ^ flip) << 2 | spread_bits(y ^ flip) << 1 | spread_bits(z ^ flip);
}

#endif
