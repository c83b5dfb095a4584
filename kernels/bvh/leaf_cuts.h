/* leaf_cuts.h - a row of boxes, cut into ranges of 8 to 16 so that the boxes around the ranges
 * have the least surface. Along the curve, what is close in space lies together, but one object
 * may end and the next begin anywhere: ranges of exactly 16 straddle such places, and rays
 * visit them in vain. With free cuts, rays visit half as many leaves.
 *
 * The least sum of the surfaces of all ranges before place j, and of a cost per range, is
 *   least(j) = min over l = 8 .. 16 of  least(j - l) + surface of [j - l, j) + cost
 * (dynamic programming). Ranges are at least 8 long, so that 8 places can be decided at a time:
 * none of them depends on another. And the box around a range is that around its first 8 and
 * its last 8.
 */
#ifndef RSH_BVH_LEAF_CUTS_H
#define RSH_BVH_LEAF_CUTS_H

#include "mesh/boxes16.h"
#include "tuning.h"

#define RSH_LEAST_RANGE 8

/* Boxes in a row, and the ranges that they are cut into, from the first box on. */
typedef struct box_row {
    float side[6][RSH_WINDOW + 16];  /* low x y z, high x y z */
    float eight[6][RSH_WINDOW + 24]; /* [8 + i]: of the box around boxes i .. i + 7 */
    uint count;
    uint range_length[RSH_WINDOW / RSH_LEAST_RANGE + 1];
    uint range_count;
} box_row;

#define RSH_LESSER8(a, b) select(b, a, a < b)
#define RSH_GREATER8(a, b) select(b, a, a > b)

/* No surface counts for more, so that sums stay finite. */
#define RSH_MOST_SURFACE 1e30f

/* Of the lower sides the least, or of the higher the greatest: of the first 8 of a, and of
 * b. */
#define RSH_JOIN8(low, a, b) \
    ((low) ? RSH_LESSER8((a).s01234567, b) : RSH_GREATER8((a).s01234567, b))

/* Doubles: boxes around 2, 4, 8. From the last box to the first, in registers: read back from
 * memory, the values would have been written in pieces of another size, which stalls a CPU.
 * What lies behind the row does not matter. */
static void bound_eights(box_row* row)
{
    for (uint f = 0; f < 6; ++f) {
        const bool low = f < 3;
        float8 one = (float8)(0.0f), two = one, four = one; /* of the 8 places behind */
        for (uint i = (row->count + 7) / 8 * 8; i > 0;) {
            i -= 8;
            const float16 ones = (float16)(vload8(0, row->side[f] + i), one);
            one = ones.lo;
            const float16 twos = (float16)(RSH_JOIN8(low, ones, ones.s12345678), two);
            two = twos.lo;
            const float16 fours = (float16)(RSH_JOIN8(low, twos, twos.s23456789), four);
            four = fours.lo;
            vstore8(RSH_JOIN8(low, fours, fours.s456789ab), 0, row->eight[f] + 8 + i);
        }
        vstore8((float8)(0.0f), 0, row->eight[f]); /* before the row: see find_cuts */
    }
}

/* Half the surfaces of 8 boxes; RSH_MOST_SURFACE for empty boxes and where it overflows. */
static float8 surfaces_of(const float8* side)
{
    const float8 most = (float8)(RSH_MOST_SURFACE);
    const float8 x = side[3] - side[0], y = side[4] - side[1], z = side[5] - side[2];
    const float8 surface = fma(x, y + z, y * z);
    return RSH_LESSER8(surface, most);
}

/* Of 8 boxes, each around the eight boxes from `at`, at + 1, ... on and those of `last`. */
static float8 surfaces_from(const box_row* row, uint at, const float8* last)
{
    float8 around[6];
#pragma unroll
    for (uint f = 0; f < 6; ++f) {
        const float8 eight = vload8(0, row->eight[f] + at);
        around[f] = f < 3 ? RSH_LESSER8(eight, last[f]) : RSH_GREATER8(eight, last[f]);
    }
    return surfaces_of(around);
}

/* length[j]: of the range that ends before place j, when everything up to there is cut best. No
 * range ends before the row begins, nor at places 1 to 7. */
static void find_cuts(const box_row* row, float range_cost, int* length)
{
    float16 least = (float16)(FLT_MAX); /* of the last 16 places */
    least.s8 = 0.0f;
    for (uint j = 8; j <= row->count; j += 8) {
        float16 before = least; /* read in parts: stored once, as a whole */
        const float* place = (const float*)&before;
        float8 last[6], sum = (float8)(FLT_MAX);
        int8 best_length = (int8)(16);
#pragma unroll
        for (uint f = 0; f < 6; ++f) last[f] = vload8(0, row->eight[f] + j);
        for (uint l = 16; l >= RSH_LEAST_RANGE; --l) {
            const float8 here = vload8(0, place + 16 - l) + surfaces_from(row, 8 + j - l, last);
            const int8 is_less = here < sum;
            sum = select(sum, here, is_less);
            best_length = select(best_length, (int8)((int)l), is_less);
        }
        vstore8(best_length, 0, length + j);
        least = (float16)(least.hi, sum + range_cost);
    }
}

/* is_last: no boxes follow. Otherwise the last ranges wait: what follows may change them. */
static void cut_row(box_row* row, float range_cost, bool is_last)
{
    row->range_count = 0;
    if (row->count < RSH_LEAST_RANGE) {
        if (row->count) row->range_length[row->range_count++] = row->count;
        return;
    }
    int length[RSH_WINDOW + 8];
    bound_eights(row);
    find_cuts(row, range_cost, length);
    for (uint j = row->count; j > 0; j -= length[j]) ++row->range_count;
    uint r = row->range_count;
    for (uint j = row->count; j > 0; j -= length[j]) row->range_length[--r] = length[j];
    if (!is_last) row->range_count -= RSH_OPEN_RANGES;
}

/* Ranges of 16, wherever that cuts. */
static void cut_evenly(box_row* row, bool is_last)
{
    bound_eights(row);
    row->range_count = row->count / 16;
    for (uint r = 0; r < row->range_count; ++r) row->range_length[r] = 16;
    if (is_last && row->count % 16) row->range_length[row->range_count++] = row->count % 16;
}

/* Sides of the box around a range. */
static void bound_range(const box_row* row, uint first, uint length, float* side)
{
#pragma unroll
    for (uint f = 0; f < 6; ++f) {
        if (length >= RSH_LEAST_RANGE) {
            __private const float* eight = row->eight[f] + 8 + first;
            const float a = eight[0], b = eight[length - 8];
            side[f] = (f < 3) == (a < b) ? a : b;
            continue;
        }
        side[f] = row->side[f][first];
        for (uint i = first + 1; i < first + length; ++i)
            if ((f < 3) == (row->side[f][i] < side[f])) side[f] = row->side[f][i];
    }
}

/* Moves `count` words, and up to 15 behind them, from `done` on to the front. */
static void shift_words(float* words, uint done, uint count)
{
    for (uint i = 0; i < count; i += 16) vstore16(vload16(0, words + done + i), 0, words + i);
}

/* Moves the boxes behind the first `done` to the front. */
static void shift_row(box_row* row, uint done)
{
    row->count -= done;
    for (uint f = 0; f < 6; ++f) shift_words(row->side[f], done, row->count);
}

#endif
