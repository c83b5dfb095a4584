/* hit_list.h - all hits of rays, in programs that are made for them (RSH_ALL_HITS): how many each ray
 * has, and, where they are listed, each as a record. Records lie in the order in which they were found.
 * An engine that takes tiles of rays may sort and pack the first hits of each ray, so that only the others
 * become records. traverse/list_hits.cl puts all of them where they belong.
 *
 * The kernels of such a program are given, in place of closest hits and occlusion:
 *   hits           records, behind a hit_records_head; NULL: hits are only counted
 *   occlusion      the number of hits per ray
 *   occlusion_bit  records that there is room for
 */
#ifndef RSH_TRAVERSE_HIT_LIST_H
#define RSH_TRAVERSE_HIT_LIST_H

#include "mesh/crossing.h"
#include "traverse/types.h"

#if RSH_ALL_HITS
#define RSH_FIND_HITS cross_triangles
#else
#define RSH_FIND_HITS intersect
#endif

typedef struct hit_list {
    __global hit_record* records;          /* 0: hits are only counted */
    volatile __global uint *used, *packed; /* see hit_records_head */
    uint capacity, at_once;
    uint next, end; /* of those taken, the ones still free */
} hit_list;

/* at_once: records to take at a time. */
static hit_list hit_list_in(__global rsh_hit* hits, uint capacity, uint at_once)
{
    __global hit_records_head* head = (__global hit_records_head*)hits;
    hit_list list = {0, 0, 0, capacity, at_once, 0, 0};
    if (!head) return list;
    list.records = (__global hit_record*)(head + 1);
    list.used = &head->used;
    list.packed = &head->packed;
    return list;
}

/* Hits that tiles have packed fill the room of the records from its end: if all hits can be records, there
 * is enough for both. This word of a tile is behind that room, and says how many hits before the end its
 * own begin; 0: it has none. */
static __global uint* packed_end_of(__global const hit_record* records, uint capacity,
                                    uint tile)
{
    return (__global uint*)(records + capacity) + tile;
}

static __global rsh_hit* packed_at(__global const hit_record* records, uint capacity, uint end)
{
    return (__global rsh_hit*)(records + capacity) - end;
}

/* rank: how many hits of the ray came before. */
static void add_to_list(hit_list* list, uint ray, uint rank, rsh_hit hit)
{
    if (!list->records) return;
    if (list->next == list->end) {
        list->next = atomic_add(list->used, list->at_once);
        list->end = list->next + list->at_once;
    }
    if (list->next < list->capacity) list->records[list->next] = (hit_record){hit, ray, rank};
    ++list->next;
}

/* Records that were taken and not needed become empty ones. */
static void close_list(hit_list* list)
{
    for (; list->next != list->end; ++list->next)
        if (list->next < list->capacity) list->records[list->next].ray = RSH_NO_HIT;
}

#endif
