/* ploc.h - how the tree of tree_boxes.h comes about. Round by round, two boxes become one
 * that lie near each other in the row and neither of which would make a smaller box with
 * another (parallel locally-ordered clustering, Meister and Bittner, TVCG 2018). What is large
 * or stands alone stays near the top, where runs along the curve put it among what it has
 * nothing to do with: rays alone open 10 to 50 % fewer groups.
 */
#ifndef RSH_BVH_PLOC_H
#define RSH_BVH_PLOC_H

#include "bvh/binary_tree.h"

/* How far in the row a box looks for another, to both sides. Two places do for all scenes but
 * one, whose bundles open half as many boxes again; 8 and 16 gain nothing. */
#define RSH_REACH 4

/* After so many rounds, neighbours become one whatever they are: rows of boxes that each would
 * have the next one, which would have the one after it, take a round for every two. */
#define RSH_FREE_ROUNDS 12

/* Boxes side by side that have none above them yet. */
typedef struct rsh_tops {
    __global float* side; /* [6][stride]: low x y z, high x y z; 16 words before the first */
    __global uint* number;
    __global uint* mate;
    uint stride, count;
} rsh_tops;

/* For those of a part, or, if `part` is the number of parts, of what is above them. */
static rsh_tops no_tops(const rsh_tree* tree, uint part)
{
    const uint room = tree->shape.part_clusters, parts = tree->shape.parts;
    const uint stride = (part < parts ? room : RSH_PART_TOPS * parts) + RSH_TOPS_MARGIN;
    __global float* words = tree->tops + (ulong)RSH_TOPS_WORDS(room) * part;
    rsh_tops tops = {words + 16, (__global uint*)(words + 6ul * stride),
                     (__global uint*)(words + 7ul * stride), stride, 0};
    return tops;
}

static void add_top(const rsh_tree* tree, rsh_tops* tops, uint number)
{
    __global const float* side = sides_of(tree, number);
    for (uint f = 0; f < 6; ++f) tops->side[(ulong)f * tops->stride + tops->count] = side[f];
    tops->number[tops->count++] = number;
}

/* Half the surfaces of boxes, as surfaces_of. */
static floatv surfaces_around(const floatv* side)
{
    const floatv x = side[3] - side[0], y = side[4] - side[1], z = side[5] - side[2];
    return lesser(fma(x, y + z, y * z), (floatv)(RSH_MOST_SURFACE));
}

/* A mate for each of the boxes from `first` on. */
typedef struct rsh_search {
    uint first;
    floatv side[6]; /* of the boxes */
    floatv surface; /* of the smallest box with another so far */
    uintv mate;
} rsh_search;

/* Boxes `step` places on, for those who ask. */
static void look_at(const rsh_tops* tops, rsh_search* search, int step, intv who)
{
    const uint at = search->first + (uint)step;
    const uintv other = as_uintv(RSH_LANES) + at;
    floatv around[6];
#pragma unroll
    for (uint f = 0; f < 6; ++f) {
        const floatv side = load_lanes(tops->side + ((long)f * tops->stride + (int)at));
        around[f] = f < 3 ? lesser(side, search->side[f]) : greater(side, search->side[f]);
    }
    const floatv surface = surfaces_around(around);
    const intv is_less = who & (other < (uintv)(tops->count)) & (surface < search->surface);
    search->surface = select(search->surface, surface, is_less);
    search->mate = select(search->mate, other, as_uintv(is_less));
}

/* Of boxes all alike, the first and the second go together, the third and the fourth: each
 * looks there first. */
static void find_mates(const rsh_tops* tops)
{
    const intv all = RSH_LANES >= (intv)(0);
    for (uint i = 0; i < tops->count; i += RSH_WIDTH) {
        rsh_search search;
        search.first = i;
        search.surface = (floatv)(INFINITY);
        search.mate = as_uintv(RSH_LANES) + i;
        const intv is_first = ((RSH_LANES + (int)i) & 1) == (intv)(0);
        for (uint f = 0; f < 6; ++f)
            search.side[f] = load_lanes(tops->side + ((ulong)f * tops->stride + i));
        look_at(tops, &search, 1, is_first);
        look_at(tops, &search, -1, all);
        look_at(tops, &search, 1, all);
        for (int step = 2; step <= RSH_REACH; ++step) {
            look_at(tops, &search, -step, all);
            look_at(tops, &search, step, all);
        }
        store_lanes(search.mate, tops->mate + i);
    }
}

static void take_neighbours(const rsh_tops* tops)
{
    for (uint i = 0; i < tops->count; ++i) tops->mate[i] = min(i ^ 1, tops->count - 1);
}

/* Mates become a branch each; `next` is the number of the first. Returns how many. */
static uint join_mates(const rsh_tree* tree, float price, rsh_tops* tops, uint next)
{
    const uint count = tops->count;
    uint branches = 0;
    tops->count = 0;
    for (uint i = 0; i < count; ++i) {
        const uint mate = tops->mate[i];
        const bool is_pair = mate != i && tops->mate[mate] == i;
        if (is_pair && mate < i) continue;
        const uint at = tops->count++;
        uint number = tops->number[i];
        float side[6];
#pragma unroll
        for (uint f = 0; f < 6; ++f) {
            __global float* row = tops->side + (ulong)f * tops->stride;
            side[f] = row[i];
            if (is_pair) side[f] = f < 3 ? fmin(side[f], row[mate]) : fmax(side[f], row[mate]);
            row[at] = side[f];
        }
        if (is_pair) {
            set_branch(tree, price, next + branches, number, tops->number[mate], side);
            number = next + branches++;
        }
        tops->number[at] = number;
    }
    return branches;
}

/* Until no more than `most` are left. first: number of the first branch. */
static void grow_tree(const rsh_tree* tree, float price, rsh_tops* tops, uint first, uint most)
{
    for (uint round = 0; tops->count > most; ++round) {
        if (round < RSH_FREE_ROUNDS)
            find_mates(tops);
        else
            take_neighbours(tops);
        first += join_mates(tree, price, tops, first);
    }
}

#endif
