// traverse_ranges.hpp - the launches of the engine `paper`: one level of the stream by count,
// scan and emit (traverse/paper/traverse_ranges.cl), what it cannot hold, and the rays at its
// end (traverse/paper/intersect_ranges.cl).
#pragma once

#include "device/cl/recorder.hpp"
#include "rays/types.h"
#include "traverse/paper/types.h"

namespace rsh {

// The pair stream of one traversal: per node a range of triangles.
struct RangeStreams {
    cl_uint capacity;     // triangles of a level
    cl_mem triangles[2];  // of the levels with even and odd numbers
    cl_mem ranges;        // of all levels, triangle_range
    cl_mem masks;         // per triangle of the parents, which children it meets
    cl_mem counts, sums;  // per slice of a parent's range
    cl_mem tally;         // RSH_TALLY_WORDS
};

struct RangeLevel {
    ray_levels shape;
    range_step step;
    cl_mem groups;       // the children of step.first_child_group and on ...
    cl_uint first_word;  // ... from this word on
};

// The children at level.step.level of the parents above: counted, then written.
void count_ranges(Recorder& recorder, const rsh_traverse_desc& desc, const RangeLevel& level,
                  const RangeStreams& streams);
void emit_ranges(Recorder& recorder, const rsh_traverse_desc& desc, const RangeLevel& level,
                 const RangeStreams& streams);
// Parents whose children do not fit, down to the hits. After the other two.
void finish_ranges(Recorder& recorder, const rsh_traverse_desc& desc, const RangeLevel& level,
                   const RangeStreams& streams);

// The ranges of level 1, that is, of the blocks.
void intersect_ranges(Recorder& recorder, const rsh_traverse_desc& desc,
                      const ray_levels& shape, const RangeStreams& streams);

// Nodes of shape `box` above the blocks, into `upper`: one box_node16 after the other, the
// first ones of tiles, the last one of the root's children.
void join_boxes(Recorder& recorder, const rsh_traverse_desc& desc, const ray_levels& shape,
                cl_mem upper);

}  // namespace rsh
