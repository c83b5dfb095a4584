/* runs.h - the pair stream of the engine `paper`: node-major, a run of triangles per node, so
 * that a pair is 4 bytes and a node is loaded once. */
#ifndef RSH_TRAVERSE_PAPER_RUNS_H
#define RSH_TRAVERSE_PAPER_RUNS_H

#include "rays/group_levels.h"
#include "traverse/paper/types.h"

typedef struct rsh_run {
    uint begin, count; /* in the stream of its level */
} rsh_run;

static rsh_run run_of(rsh_run_step step, __global const uint2* runs, uint parent)
{
    if (step.is_root) return (rsh_run){0, step.batch_count};
    const uint2 run = runs[step.first_parent_run + parent];
    return (rsh_run){run.x, run.y};
}

/* Piece `number` of a run. */
static rsh_run piece_of(rsh_run run, uint number, uint pieces)
{
    const uint begin = (uint)((ulong)run.count * number / pieces);
    const uint end = (uint)((ulong)run.count * (number + 1) / pieces);
    return (rsh_run){run.begin + begin, end - begin};
}

static uint triangle_at(rsh_run_step step, __global const uint* triangles, uint i)
{
    return step.is_root ? step.batch_first + i : triangles[i];
}

/* Where the survivors of a parent begin, from the sums of the pieces before it; sums[all
 * pieces]: how many there are. */
static uint survivors_before(rsh_run_step step, __global const uint* sums, uint parent)
{
    return sums[parent * step.pieces];
}

/* The stream cannot hold the survivors of this parent: finish_runs.cl sees to its run. Known
 * before anything is written. */
static bool is_left_over(rsh_run_step step, __global const uint* sums, uint parent)
{
    return survivors_before(step, sums, parent + 1) > step.capacity;
}

#endif
