// rsh_tracer.hpp - one frame of rsh over given rays: clear (occlusion only), rsh_bound,
// rsh_build and rsh_traverse on one in-order queue, with buffers of its own that are made once.
// Makes no rays and checks no answer.
#pragma once

#include <array>

#include "frame/ray_maker.hpp"

namespace bench {

// A column of the tables: how rsh traverses, and whether the scene's bounds are made anew in every
// frame, or refitted.
struct Column {
    cl_uint engine = RSH_ENGINE_DEFAULT;
    cl_uint bound = RSH_SHAPE_DEFAULT;
    std::string engine_name, bound_name;
    bool is_refit = false;
    cl_uint vector_width = 0;  // of the kernels; 0: the library's choice

    std::string name() const;  // "engine:tiles/bound:box", and "/refit", "/vectors:8"
};

struct FrameTimes {
    double total = 0, bound = 0, build = 0, traverse = 0;  // ms; the sum of the last three is
                                                           // total, the first of them with the
                                                           // time until the device starts
};

struct FrameWork {
    double tests_per_ray = 0;
    cl_ulong peak_pairs = 0, launches = 0;
    std::array<double, RSH_STAGE_COUNT>
        stage_ms{};  // of the commands of a stage, by their events
};

class RshTracer {
public:
    // With RSH_QUERY_ANY, `rays` are shadow rays of a point light; RSH_QUERY_ALL has room for as many
    // hits as set_hit_capacity says. Allocates nothing yet: needs() are the buffers of allocate(),
    // which comes before all else.
    RshTracer(const Device& device, const rsh_geometry& geometry, Size size, cl_uint query,
              const Column& column);
    void set_hit_capacity(cl_ulong hits);

    std::vector<NamedBytes> needs() const;
    void allocate();

    // Shadow rays are built as converging ones, others are not, unless this says otherwise.
    void set_converging(bool is_converging) { build_.converging = is_converging; }
    // A triangle per ray, as rsh_traverse_desc::skip.
    void set_skip(const cl::Buffer& skip) { traverse_.skip = skip(); }
    // Of no more triangles than the one that there was at first.
    void set_geometry(const rsh_geometry& geometry) {
        bound_.geometry = traverse_.geometry = geometry;
    }
    void spoil_answers();  // none of an earlier frame is left

    FrameTimes trace(const cl::Buffer& rays);  // BLOCKS
    double bound();                            // the scene's side alone; ms; BLOCKS
    void build(const cl::Buffer& rays);        // the hierarchy alone; BLOCKS
    size_t mismatches() const;  // of the last frame, in a sample of its active rays; BLOCKS
    FrameWork count(const cl::Buffer& rays, size_t active_rays);

    // Of the last frame, by the query:
    std::vector<rsh_hit> hits() const;       // closest, all: as many as there is room for
    std::vector<cl_uint> occlusion() const;  // any
    std::vector<cl_uint> counts() const;     // count
    std::vector<cl_ulong> offsets() const;   // all
    size_t bytes() const { return bytes_; }  // all that a frame needs but rays, hits, geometry

private:
    void find_sizes();
    cl::Buffer own(size_t bytes);
    size_t answer_bytes() const;
    bool is_shadow() const { return traverse_.query == RSH_QUERY_ANY; }
    template <class T>
    std::vector<T> read(const cl::Buffer& buffer, size_t count) const;

    const Device& device_;
    Size size_;
    bool is_refit_;
    size_t bytes_ = 0;
    size_t bounds_bytes_ = 0, nodes_bytes_ = 0, scratch_bytes_ = 0;
    rsh_bound_desc bound_{};
    rsh_build_desc build_{};
    rsh_traverse_desc traverse_{};
    cl::Buffer bounds_, nodes_, scratch_, answers_, offsets_;
};

}  // namespace bench
