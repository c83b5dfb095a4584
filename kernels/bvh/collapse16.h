/* collapse16.h - nodes of 16 children out of the binary tree of bvh/binary_tree.h, from the top
 * down: a branch that is a node takes its two children, and theirs, as is the cheapest;
 * branches that remain in its slots become nodes themselves.
 *
 * Claim: of G nodes above L leaves, in the whole tree or in a part, G <= (L - 1) / 8, or G = 1.
 * That is the room that there is. Let a node use s of its slots, and a branch in one of them s'
 * slots when it is a node itself. If s' <= 17 - s, its own slot and the free ones would do for
 * its children, at less than the cost of a node, and fill_free_slots would have replaced it;
 * hence s + s' >= 18. Below the topmost, a node with s < 9 slots has a branch in one of them,
 * as there are nodes only above RSH_LEAST_LEAVES = 9 leaves and more; what it lacks to 9 slots,
 * that child node has beyond 9. So nodes use 9 slots on the average, and more. Slots hold every
 * node but the topmost, and all leaves: 9 G <= G - 1 + L.
 *
 * Nodes are numbered from the last one down, so that a node's children come before it; the
 * children of one node are neighbours in memory.
 */
#ifndef RSH_BVH_COLLAPSE16_H
#define RSH_BVH_COLLAPSE16_H

#include "bvh/binary_tree.h"

/* The children that a node is going to have: numbers of leaves and branches. */
typedef struct node_slots {
    uint number[16];
    uint count;
} node_slots;

/* Of `slot_count` slots, how many the first child of a branch has; 0: the branch is a node. */
static uint first_slots(const binary_tree* tree, uint number, uint slot_count)
{
    return ((__global const uchar*)branch_of(tree, number)->slot_split)[slot_count - 1];
}

/* Adds what takes the place of a branch in `slot_count` slots, at least 2: its children,
 * theirs, ... as is the cheapest. */
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

/* Where slots are free, a branch that gains nothing by being a node is replaced by its
 * children: where sums were rounded to the same. */
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

/* Has a branch become a node, later, in the part that it lies in. Returns the node's number. */
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
RSH_CALLED static void make_node(const binary_tree* tree, uint number, uint node,
                                 __global float* bvh)
{
    const node_slots slots = slots_of(tree, number);
    store_slots(tree, &slots, bvh + node_at(&tree->layout.whole, node));
}

/* Makes the nodes of a part that wait, and those that come to wait while it does. */
RSH_CALLED static void make_waiting_nodes(const binary_tree* tree, __global tree_part* part,
                                          __global float* bvh)
{
    while (part->waiting != RSH_NO_BRANCH) {
        const uint number = part->waiting;
        part->waiting = branch_of(tree, number)->next;
        make_node(tree, number, branch_of(tree, number)->node, bvh);
    }
}

#endif
