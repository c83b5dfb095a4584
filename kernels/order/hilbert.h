/* hilbert.h - places along Hilbert's curve through a grid of cells, a point per lane.
 * Consecutive cells share a face, so that ranges along the curve are compact; along Morton's
 * curve, which jumps, 1.5 to 2 times as many rays meet their boxes.
 *
 * Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707, 2004.
 */
#ifndef RSH_ORDER_HILBERT_H
#define RSH_ORDER_HILBERT_H

#include "lanes/sixteen.h"

/* Vectors of points that take each step together, as the next step waits for it. */
#define RSH_ABREAST (RSH_WIDTH > 1 ? RSH_VECTORS : 1)
#define for_each_abreast(v) _Pragma("unroll") for (uint v = 0; v < RSH_ABREAST; ++v)

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

/* x, y, z of cells: each below 2^bits; bits is 7 at most. They are changed on the way. */
static void hilbert_places(uintv* x, uintv* y, uintv* z, uint bits, uintv* place)
{
    for (uint bit = bits - 1; bit > 0; --bit) {
        const uint lower_bits = (1u << bit) - 1;
        for_each_abreast(v) {
            x[v] ^= mask_of(x[v], bit) & lower_bits;
            turn(x + v, y + v, bit);
            turn(x + v, z + v, bit);
        }
    }
    uintv flip[RSH_ABREAST];
    for_each_abreast(v) {
        y[v] ^= x[v];
        z[v] ^= y[v];
        flip[v] = (uintv)(0u);
    }
    for (uint bit = bits - 1; bit > 0; --bit)
        for_each_abreast(v) flip[v] ^= mask_of(z[v], bit) & ((1u << bit) - 1);
    for_each_abreast(v)
        place[v] = spread_bits(x[v] ^ flip[v]) << 2 | spread_bits(y[v] ^ flip[v]) << 1 |
                   spread_bits(z[v] ^ flip[v]);
}

#endif
