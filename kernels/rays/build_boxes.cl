/* build_boxes.cl - the ray hierarchy of node shape `box`, bottom-up.
 *   rays        in   level 0
 *   list_count  in   how many rays of a list there are; NULL: all
 *   sorting     in   whether a list has an order, which lies in `nodes` from word order_at on;
 *                    NULL: none
 *   nodes       out  box_node16 per tile: its blocks
 * A work-item reads the 256 rays of a tile once and writes its 16 blocks. Does not test
 * anything against the scene.
 */
#include "lanes/stride.h"
#include "order/types.h"
#include "rays/box_node.h"
#include "rays/levels.h"
#include "rays/nodes_head.h"
#include "rays/tile_layout.h"

static float smallest_active(const ray_block* block, const floatv* row)
{
    floatv v[RSH_VECTORS];
    for_each_vector(i) v[i] = select((floatv)(INFINITY), row[i], block->is_active[i]);
    return smallest_lane(v);
}

static float largest_active(const ray_block* block, const floatv* row)
{
    floatv v[RSH_VECTORS];
    for_each_vector(i) v[i] = select((floatv)(-INFINITY), row[i], block->is_active[i]);
    return largest_lane(v);
}

/* The largest component between low and high, in size. */
static float reach_of(float low, float high) { return fmax(fabs(low), fabs(high)); }

/* The same rays seen from their points at t = 1, backwards: where they run towards one
 * point, the box of those points is the smallest. Every point with 0 <= t <= 1 lies that
 * way. A ray that goes on behind t = 1, or whose point there overflows, makes the node
 * universal: all directions, from everywhere. The sum rounds by u of itself, which the
 * padding has room for. */
static void reverse_rays(ray_block* block)
{
    for_each_vector(v) {
        intv is_bounded = block->row[RSH_TMAX][v] <= (floatv)(1.0f);
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv d = block->row[RSH_DIRECTION + axis][v];
            block->row[axis][v] += d;
            block->row[RSH_DIRECTION + axis][v] = -d;
            is_bounded &= fabs(block->row[axis][v]) < (floatv)(INFINITY);
        }
        /* NaN in an active lane makes the node universal. */
        const intv is_lost = block->is_active[v] & (is_bounded == (intv)(0));
        block->row[0][v] = select(block->row[0][v], (floatv)(NAN), is_lost);
        block->row[RSH_TMAX][v] = (floatv)(1.0f);
    }
}

static bool any_lost(const ray_block* block)
{
    bool lost = false;
    for_each_vector(v)
        lost |= any_lane(block->is_active[v] & (block->row[0][v] != block->row[0][v]));
    return lost;
}

typedef struct node_rows {
    float row[RSH_NODE_ROWS][16];
} node_rows;

/* Bounds block b; writes its lane of the rows. */
static void bound_block(ray_block* block, uint is_converging, uint b, node_rows* rows)
{
    float reach = 0.0f;
    for (uint axis = 0; axis < 3; ++axis)
        reach = fmax(reach, reach_of(smallest_active(block, block->row[axis]),
                                     largest_active(block, block->row[axis])));
    if (is_converging) reverse_rays(block);
    const bool is_universal = is_converging && any_lost(block);
    float low[3], high[3];
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = is_universal ? -INFINITY : smallest_active(block, block->row[axis]);
        high[axis] = is_universal ? INFINITY : largest_active(block, block->row[axis]);
        reach = fmax(reach, reach_of(low[axis], high[axis]));
    }
    const float pad = is_universal ? 0.0f : pad_of(reach);
    for (uint axis = 0; axis < 3; ++axis) {
        const floatv* direction = block->row[RSH_DIRECTION + axis];
        rows->row[axis][b] = low[axis] - pad;
        rows->row[3 + axis][b] = high[axis] + pad;
        rows->row[6 + axis][b] = is_universal ? -INFINITY : smallest_active(block, direction);
        rows->row[9 + axis][b] = is_universal ? INFINITY : largest_active(block, direction);
    }
    rows->row[12][b] = largest_active(block, block->row[RSH_TMAX]);
}

/* A block without active rays. */
static void clear_rows(uint b, node_rows* rows)
{
    for (uint f = 0; f < 6; ++f) {
        const float bound = f < 3 ? INFINITY : -INFINITY;
        rows->row[f][b] = rows->row[6 + f][b] = bound;
    }
    rows->row[12][b] = -1.0f;
}

RSH_CALLED static void bound_tile(ray_tile tile, __global const rsh_ray* rays,
                                  uint is_converging, node_rows* rows)
{
    for (uint b = 0; b < 16; ++b) {
        ray_block block;
        load_block(tile, b, rays, &block);
        rows->row[13][b] = as_float(is_converging);
        if (active_lanes(&block))
            bound_block(&block, is_converging, b, rows);
        else
            clear_rows(b, rows);
    }
}

RSH_CALLED static void store_rows(const node_rows* rows, __global float* out)
{
    for (uint f = 0; f < RSH_NODE_ROWS; ++f)
        for_each_vector(v)
            store_lanes(load_lanes(rows->row[f] + RSH_WIDTH * v), out + 16 * f + RSH_WIDTH * v);
}

RSH_FILLS_VECTORS
__kernel void rsh_build_boxes(ray_levels shape, __global const uint* list_count,
                              __global const rsh_ray* rays, uint is_converging,
                              __global const sort_plan* sorting, uint order_at,
                              __global float* nodes)
{
    const ray_levels levels = counted_levels(shape, list_count);
    const bool is_sorted = sorting && sorting->is_needed;
    if (get_global_id(0) == 0)
        write_nodes_head(shape, levels.width[0], RSH_BOXES_MADE, is_sorted ? order_at : 0,
                         nodes);
    const uint me = my_element(tile_count(levels));
    if (me == tile_count(levels)) return; /* the launch is for all places */
    const ray_tile tile =
        tile_at(levels, is_sorted ? (__global const uint*)nodes + order_at : 0, me);
    node_rows rows;
    bound_tile(tile, rays, is_converging, &rows);
    store_rows(&rows, nodes + RSH_NODES_HEAD_WORDS + 16ul * RSH_NODE_ROWS * me);
}
