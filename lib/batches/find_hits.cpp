#include "batches/find_hits.hpp"

#include "bvh/layout.hpp"
#include "bvh/scene_bounds.hpp"
#include "traverse/engine.hpp"
#include "traverse/intersect.hpp"

namespace rsh {
namespace {

void bound_batch(Recorder& recorder, const SceneBatch& batch, const BatchMemory& memory,
                 cl_uint shape) {
    rsh_bound_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = batch.geometry;
    pass.shape = shape;
    pass.bounds = memory.bounds;
    pass.scratch = memory.bound_scratch;
    bound(recorder, pass);
}

}  // namespace

size_t batch_scratch_bytes(const Context& context, const rsh_traverse_desc& pass,
                           cl_uint triangles) {
    rsh_traverse_desc batch = pass;
    batch.continued = 1;
    return most_bytes_up_to(triangles, [&](cl_uint count) {
        batch.geometry.triangle_count = count;
        return traverse_scratch(context, batch, BoundsFrom::caller).bytes();
    });
}

void find_hits(Recorder& recorder, BatchFeed& feed, const BatchMemory& memory,
               rsh_traverse_desc pass, const SeenTriangles* seen) {
    clear_hits(recorder, pass, "traverse/clear_hits");
    pass.continued = 1;
    pass.bounds = memory.bounds;
    feed.for_each([&](const SceneBatch& batch, bool is_new) {
        if (is_new && memory.bounds) bound_batch(recorder, batch, memory, pass.shape);
        pass.geometry = batch.geometry;
        pass.first_triangle = batch.first_triangle;
        traverse(recorder, pass);
        if (seen) keep_seen(recorder, batch, memory, pass, *seen);
    });
    if (seen) number_seen(recorder, pass, *seen);
}

}  // namespace rsh
