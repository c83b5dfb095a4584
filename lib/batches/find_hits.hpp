// find_hits.hpp - what rays hit in a scene that comes in batches: per batch bound and traverse, from the
// answers of the batches before.
#pragma once

#include "batches/batch_feed.hpp"

namespace rsh {

// Scratch of a traversal of a batch of up to so many triangles.
size_t batch_scratch_bytes(const Context& context, const rsh_traverse_desc& pass,
                           cl_uint triangles);

// Closest hits, or a bit per ray. `pass` has no geometry; its hits name triangles of the scene in the end, or,
// where `seen` keeps these, places in there.
void find_hits(Recorder& recorder, BatchFeed& feed, const BatchMemory& memory,
               rsh_traverse_desc pass, const SeenTriangles* seen);

}  // namespace rsh
