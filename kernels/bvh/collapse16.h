/* collapse16.h - groups of 16 boxes out of the binary tree of tree_boxes.h: from the top down,
 * a group takes the boxes below a branch, and those below these, as is the cheapest; branches
 * that remain in it become groups themselves.
 *
 * There is room for an eighth as many groups as clusters. Where a group has s slots in use and
 * one of those in it would use s' slots, s + s' >= 18, or it had been taken apart into the free
 * ones (take_more). So those in a group with s < 9 use more than 9 by at least 9 - s, and each
 * group, but for the topmost, has at least one in it or 9 clusters. On the average each uses 9
 * slots at least: of G groups above L clusters, 9 G <= G - 1 + L, or G <= (L - 1) / 8. The
 * same holds among the groups of one part.
 * Groups get their numbers from the last on, so that those in them come before; those of one
 * group are neighbours.
 */
#ifndef RSH_BVH_COLLAPSE16_H
#define RSH_BVH_COLLAPSE16_H

#include "bvh/binary_tree.h"

/* Boxes that are going to be in a group, by their numbers. */
typedef struct rsh_slots {
    uint number[16];
    uint count;
} rsh_slots;

/* How many of `share` slots go to the first box below a branch; 0: it is a group of its own. */
static uint first_share(const rsh_tree* tree, uint number, uint share)
{
    return ((__global const uchar*)branch_of(tree, number)->shares)[share - 1];
}

/* The boxes below a branch, and below these, that take up to `share` slots, at least 2. */
static void take_apart(const rsh_tree* tree, uint number, uint share, rsh_slots* slots)
{
    uint todo[16] = {number}, shares[16] = {share}, count = 1;
    while (count) {
        const uint at = todo[--count], left = shares[count];
        const uint first = is_branch(tree, at) ? first_share(tree, at, left) : 0;
        if (first == 0) {
            slots->number[slots->count++] = at;
            continue;
        }
        todo[count] = branch_of(tree, at)->below[1];
        shares[count++] = left - first;
        todo[count] = branch_of(tree, at)->below[0];
        shares[count++] = first;
    }
}

/* Where slots are free, branches that would be groups for no gain are taken apart: where sums
 * were rounded to the same. */
static void take_more(const rsh_tree* tree, rsh_slots* slots)
{
    for (uint s = 0; s < slots->count && slots->count < 16;) {
        const uint number = slots->number[s], share = 17 - slots->count;
        if (!is_branch(tree, number) || first_share(tree, number, share) == 0) {
            ++s;
            continue;
        }
        slots->number[s] = slots->number[--slots->count];
        take_apart(tree, number, share, slots);
    }
}

static rsh_slots slots_below(const rsh_tree* tree, uint number)
{
    rsh_slots slots = {{number}, 1};
    if (!is_branch(tree, number)) return slots; /* the scene's only cluster */
    slots.count = 0;
    take_apart(tree, number, 16, &slots);
    take_more(tree, &slots);
    return slots;
}

/* The branch is to be a group, of the part that it is in. Returns the group's number. */
static uint put_off(const rsh_tree* tree, uint number)
{
    __global rsh_box_branch* branch = branch_of(tree, number);
    const uint at = number - RSH_CLUSTERS(tree->shape);
    __global rsh_tree_part* part =
        tree->parts + min(at / tree->shape.part_clusters, tree->shape.parts);
    branch->group = --part->first_group;
    branch->next = part->waiting;
    part->waiting = number;
    return branch->group;
}

static void store_slots(const rsh_tree* tree, const rsh_slots* slots, __global float* group)
{
    float side[6][16];
    uint below[16];
    for (uint k = 0; k < 16; ++k) {
        const bool is_there = k < slots->count;
        const uint number = slots->number[is_there ? k : 0];
        __global const float* of = sides_of(tree, number);
        for (uint f = 0; f < 6; ++f) side[f][k] = is_there ? of[f] : no_side(f);
        below[k] = !is_there                 ? RSH_NO_BOX
                   : is_branch(tree, number) ? put_off(tree, number)
                                             : tree->clusters[number].below;
    }
    for (uint f = 0; f < 6; ++f) vstore16(vload16(0, side[f]), f, group);
    vstore16(vload16(0, below), 0, (__global uint*)group + RSH_BELOW_AT);
}

/* Makes the group of a branch, or of the scene's only cluster. */
static void make_group(const rsh_tree* tree, uint number, uint group, __global float* boxes)
{
    const rsh_slots slots = slots_below(tree, number);
    store_slots(tree, &slots, boxes + box_group_at(&tree->shape, group));
}

/* Makes the groups that wait for a part, and those in them that do then. */
static void make_waiting_groups(const rsh_tree* tree, __global rsh_tree_part* part,
                                __global float* boxes)
{
    while (part->waiting != RSH_NO_BRANCH) {
        const uint number = part->waiting;
        part->waiting = branch_of(tree, number)->next;
        make_group(tree, number, branch_of(tree, number)->group, boxes);
    }
}

#endif
