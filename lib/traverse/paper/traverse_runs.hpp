// traverse_runs.hpp - the launches of the engine `paper`: one level of the stream by count, scan
// and emit (traverse/paper/traverse_runs.cl), what it cannot hold, and the rays at its end (traverse/paper/intersect_runs.cl).
#pragma once

#include "device/cl/recorder.hpp"
#include "traverse/paper/types.h"

namespace rsh {

// The pair stream of one traversal: per node a run of triangles.
struct RunStreams {
    cl_uint capacity;     // triangles of a level
    cl_mem triangles[2];  // of the levels with even and odd numbers
    cl_mem runs;          // of all levels, rsh_run
    cl_mem masks;         // per triangle of the parents, which children it meets
    cl_mem counts, sums;  // per piece of a parent's run
    cl_mem tally;         // RSH_TALLY_WORDS
};

struct RunLevel {
    rsh_levels shape;
    rsh_run_step step;
    cl_mem groups;  // the children of step.first_group and on
};

// The children at level.step.level of the parents above: counted, then written.
void count_runs(Recorder& recorder, const rsh_traverse_desc& desc, const RunLevel& level,
                const RunStreams& streams);
void emit_runs(Recorder& recorder, const RunLevel& level, const RunStreams& streams);
// Parents whose children do not fit, down to the hits. After the other two.
void finish_runs(Recorder& recorder, const rsh_traverse_desc& desc, const RunLevel& level,
                 const RunStreams& streams);

// No ray has hit anything yet.
void clear_run_hits(Recorder& recorder, const rsh_traverse_desc& desc);
// The runs of level 1, that is, of the blocks.
void intersect_runs(Recorder& recorder, const rsh_traverse_desc& desc, const rsh_levels& shape,
                    const RunStreams& streams);

// Nodes of the bound `box` above the tiles, into `upper`, numbered from the first group of the
// tiles' own level.
void join_boxes(Recorder& recorder, const rsh_levels& shape, cl_mem tiles, cl_mem upper);

}  // namespace rsh
