/* collapse16.h - groups of 16 boxes out of the binary tree of bvh/binary_tree.h: from the top down,
 * a node takes the boxes below a branch, and those below these, as is the cheapest; branches
 * that remain in it become nodes themselves.
 *
 * There is room for an eighth as many nodes as leaves. Where a node has s slots in use and
 * one of those in it would use s' slots, s + s' >= 18, or it had been taken apart into the free
 * ones (fill_free_slots). So those in a node with s < 9 use more than 9 by at least 9 - s, and each
 * node, but for the topmost, has at least one in it or 9 leaves. On the average each uses 9
 * slots at least: of G nodes above L leaves, 9 G <= G - 1 + L, or G <= (L - 1) / 8. The
 * same holds among the nodes of one part.
 * Nodes get their numbers from the last on, so that those in them come before; those of one
 * node are neighbours.
 */
#ifndef RSH_BVH_COLLAPSE16_H
#define RSH_BVH_COLLAPSE16_H

#include "bvh/binary_tree.h"

/* Boxes that are going to be in a node, by their numbers. */
typedef struct node_slots {
    uint number[16];
    uint count;
} node_slots;

/* How many of `slot_count` slots go to the first box below a branch; 0: it is a node of its own. */
static uint first_slots(const binary_tree* tree, uint number, uint slot_count)
{
    return ((__global const uchar*)branch_of(tree, number)->slot_split)[slot_count - 1];
}

/* The boxes below a branch, and below these, that take up to `slot_count` slots, at least 2. */
static void expand_branch(const binary_tree* tree, uint number, uint slot_count,
                          node_slots* slots)
{
    uint todo[16] = {number}, slot_counts[16] = {slot_count}, count = 1;
    while (count) {
        const uint at = todo[--count], left = slot_counts[count];
        const uint first = is_branch(tree, at) ? first_slots(tree, at, left) : 0;
        if (first == 0) {
            slots->number[slots->count++] = at;
            continue;
        }
        todo[count] = branch_of(tree, at)->child[1];
        slot_counts[count++] = left - first;
        todo[count] = branch_of(tree, at)->child[0];
        slot_counts[count++] = first;
    }
}

/* Where slots are free, branches that would be nodes for no gain are taken apart: where sums
 * were rounded to the same. */
static void fill_free_slots(const binary_tree* tree, node_slots* slots)
{
    for (uint s = 0; s < slots->count && slots->count < 16;) {
        const uint number = slots->number[s], slot_count = 17 - slots->count;
        if (!is_branch(tree, number) || first_slots(tree, number, slot_count) == 0) {
            ++s;
            continue;
        }
        slots->number[s] = slots->number[--slots->count];
        expand_branch(tree, number, slot_count, slots);
    }
}

static node_slots slots_of(const binary_tree* tree, uint number)
{
    node_slots slots = {{number}, 1};
    if (!is_branch(tree, number)) return slots; /* the scene's only leaf */
    slots.count = 0;
    expand_branch(tree, number, 16, &slots);
    fill_free_slots(tree, &slots);
    return slots;
}

/* The branch is to be a node, of the part that it is in. Returns the node's number. */
static uint schedule_node(const binary_tree* tree, uint number)
{
    __global tree_branch* branch = branch_of(tree, number);
    const uint at = number - RSH_LEAVES(tree->layout);
    __global tree_part* part =
        tree->parts + min(at / tree->layout.part_leaves, tree->layout.parts);
    branch->node = --part->first_node;
    branch->next = part->waiting;
    part->waiting = number;
    return branch->node;
}

static void store_slots(const binary_tree* tree, const node_slots* slots, __global float* node)
{
    float side[6][16];
    uint child[16];
    for (uint k = 0; k < 16; ++k) {
        const bool is_there = k < slots->count;
        const uint number = slots->number[is_there ? k : 0];
        __global const float* of = sides_of(tree, number);
        for (uint f = 0; f < 6; ++f) side[f][k] = is_there ? of[f] : empty_side(f);
        child[k] = !is_there                 ? RSH_NO_CHILD
                   : is_branch(tree, number) ? schedule_node(tree, number)
                                             : tree->leaves[number].child;
    }
    for (uint f = 0; f < 6; ++f) vstore16(vload16(0, side[f]), f, node);
    vstore16(vload16(0, child), 0, (__global uint*)node + RSH_CHILDREN_AT);
}

/* Makes the node of a branch, or of the scene's only leaf. */
static void make_node(const binary_tree* tree, uint number, uint node, __global float* bvh)
{
    const node_slots slots = slots_of(tree, number);
    store_slots(tree, &slots, bvh + node_at(&tree->layout, node));
}

/* Makes the nodes that wait for a part, and those in them that do then. */
static void make_waiting_nodes(const binary_tree* tree, __global tree_part* part,
                               __global float* bvh)
{
    while (part->waiting != RSH_NO_BRANCH) {
        const uint number = part->waiting;
        part->waiting = branch_of(tree, number)->next;
        make_node(tree, number, branch_of(tree, number)->node, bvh);
    }
}

#endif
