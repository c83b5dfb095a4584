// traverse_level.hpp - one level of the traversal: cone-sphere tests of a stream of pairs
// (traverse/paper_faithful/traverse_level.cl), and the depth-first end of what the stream
// cannot hold (traverse/paper_faithful/traverse_walk.cl).
#pragma once

#include "device/cl/recorder.hpp"
#include "rays/types.h"

namespace rsh {

// The streams of one traversal. A level's test reads at most `limit` pairs and writes four
// tested pairs for each; the reduction packs them into `pairs` and counts them in
// counts[level]. Those with the root, a batch's triangles, are counted alone.
struct PairStreams {
    cl_uint limit;
    cl_mem pairs;
    cl_mem tested_pairs;
    cl_mem tested_count;
    cl_mem counts;  // cl_uint per level
};

struct Batch {
    cl_uint first_triangle;
    cl_uint triangle_count;
};

// Children at `level` of the pairs at level + 1; of none where that is above the root.
void test_level(Recorder& recorder, const rsh_traverse_desc& desc, const ray_levels& levels,
                cl_uint level, const PairStreams& streams, const Batch& batch);
// Finishes the pairs at level + 1 beyond the limit.
void walk_level(Recorder& recorder, const rsh_traverse_desc& desc, const ray_levels& levels,
                cl_uint level, const PairStreams& streams);

}  // namespace rsh
