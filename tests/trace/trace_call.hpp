// trace_call.hpp - rsh_trace over host data: upload, ask for the sizes, call, wait, check the guards, read back.
#pragma once

#include <optional>

#include "support/trace.hpp"

namespace test {

// How rays are handed over.
enum class Handed {
    whole,        // as rsh_ray
    interleaved,  // six floats, origin and direction, without an interval
    apart         // four arrays, each in a buffer with other things
};

struct TraceWay {
    TraceOptions options;
    Handed handed = Handed::whole;
    bool normals = false;
    bool points = false;
    std::vector<rsh_mesh_range> ranges = {};  // with ids of the hits
};

struct TraceAnswers {
    std::vector<rsh_hit> hits;
    std::vector<Float3> normals, points;  // as asked for
    std::vector<uint32_t> ids;            // likewise
};

TraceAnswers trace_hits(const DeviceMesh& mesh, const Rays& rays, const TraceWay& way);
std::vector<uint32_t> trace_occlusion(const DeviceMesh& mesh, const Rays& rays,
                                      const std::vector<uint32_t>& masks, uint32_t bit,
                                      const TraceWay& way);

std::vector<uint32_t> trace_counts(const DeviceMesh& mesh, const Rays& rays,
                                   const TraceWay& way);

// All hits; `hits` of the answers has `capacity` of them.
struct TraceLists {
    std::vector<uint64_t> offsets;
    TraceAnswers answers;
};
TraceLists trace_lists(const DeviceMesh& mesh, const Rays& rays, uint64_t capacity,
                       const TraceWay& way);

// Without what six floats cannot tell.
Rays without_intervals(Rays rays);

}  // namespace test
