/* descend_packet.h - one block of a tile through what the stack holds: its rays together, or one
 * by one where few of them meet a box. */
#ifndef RSH_TRAVERSE_TILES_DESCEND_PACKET_H
#define RSH_TRAVERSE_TILES_DESCEND_PACKET_H

#include "traverse/tiles/descend_ray.h"
#include "traverse/tiles/leaf.h"

/* So many rays go on alone; more, where boxes that the block meets were met by none of them. */
#define RSH_FEW_RAYS 3

/* A block on its way. */
typedef struct rsh_block_probe {
    uint b;
    const int* sign; /* that of all rays per axis, or 0 */
    uint wasted;     /* visits that met no ray, less those that did */
} rsh_block_probe;

static void visit_box_by_block(rsh_work* work, rsh_block_probe* probe, const rsh_box* box)
{
    rsh_block* block = block_of(work, probe->b);
    uint rays = 0; /* not known */
    if (block->is_fit) {
        work->node_tests += 16;
        rays = rays_meeting(block, probe->sign, box->low, box->high);
        const uint few = RSH_FEW_RAYS + probe->wasted;
        probe->wasted = rays ? probe->wasted - (probe->wasted > 0) : probe->wasted + 1;
        if (popcount(rays) <= few) {
            for (; rays; rays &= rays - 1)
                traverse_ray(work, probe->b, lowest_bit(rays), box->below);
            lower_block_limit(work, probe->b);
            return;
        }
    }
    if (is_cluster(box->below))
        intersect_cluster_by_block(work, probe->b, probe->sign, box, rays);
    else
        push_boxes_met(work, block_bundle(work, probe->b), box->below);
}

/* What lies on the stack above bottom. */
static void traverse_block(rsh_work* work, rsh_block_probe* probe, uint bottom)
{
    while (work->stack_size > bottom) {
        const ulong top = work->stack[--work->stack_size];
        if (near_of(top) > lane_of(work->blocks.limit, probe->b)) continue;
        const rsh_box box = load_box(work, name_of(top));
        visit_box_by_block(work, probe, &box);
    }
}

#endif
