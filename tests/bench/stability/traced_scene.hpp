// traced_scene.hpp - a scene of triangles and rays on the device, traced by every engine.
#pragma once

#include "frame/rsh_tracer.hpp"
#include "stability/all_hits.hpp"
#include "stability/family.hpp"

namespace bench::stability {

class TracedScene {
public:
    TracedScene(const Device& device, const Scene& scene);

    // In screen order, or as a list; bounds are made anew, or kept over the frames before.
    std::vector<rsh_hit> closest(const Column& column, bool is_list) const;
    std::vector<cl_uint> any(const Column& column, bool is_list) const;
    std::vector<cl_uint> counts(const Column& column, bool is_list) const;
    // capacity: how many there may be. If there are more, they are asked for again.
    AllHits all(const Column& column, bool is_list, cl_ulong capacity) const;

    // With buffers, and nothing traced yet. capacity: of the query all.
    RshTracer tracer(const Column& column, bool is_list, cl_uint query,
                     cl_ulong capacity = 0) const;

private:
    rsh_geometry geometry_of(size_t vertex_count) const;
    void show(const std::vector<test::Float3>& vertices, RshTracer& tracer) const;
    RshTracer traced(const Column& column, bool is_list, cl_uint query,
                     cl_ulong capacity = 0) const;

    const Device& device_;
    Size size_;
    bool is_converging_;
    std::vector<std::vector<test::Float3>> frames_;  // this one is the last
    cl::Buffer vertices_, indices_, rays_, skip_;
    rsh_geometry largest_{};  // of all frames
};

// All engines with each bound that they take; brute force, which takes none, first.
std::vector<Column> engines(const Device& device);

}  // namespace bench::stability
