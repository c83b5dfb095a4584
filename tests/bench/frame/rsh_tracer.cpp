// rsh_tracer.cpp - descriptors, buffers, and the frame with its stages.
#include "frame/rsh_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "timing.hpp"

namespace bench {
namespace {

rsh_sizes empty_sizes() {
    rsh_sizes sizes{};
    sizes.struct_size = sizeof sizes;
    return sizes;
}

// Ray-triangle tests of an audit that take about half a second on two cores.
constexpr double kTests = 1.5e8;

double end_ms(const cl::Event& event) {
    return 1e-6 * double(event.getProfilingInfo<CL_PROFILING_COMMAND_END>());
}

}  // namespace

std::string Column::name() const {
    return fmt::format("engine:{}/bound:{}{}{}", engine_name, bound_name,
                       is_refit ? "/refit" : "",
                       vector_width > 0 ? fmt::format("/vectors:{}", vector_width) : "");
}

RshTracer::RshTracer(const Device& device, const rsh_geometry& geometry, Size size,
                     cl_uint query, const Column& column)
    : device_(device), size_(size), is_refit_(column.is_refit) {
    bound_.struct_size = sizeof bound_;
    bound_.geometry = geometry;
    bound_.mode = is_refit_ ? RSH_BOUND_QUALITY : RSH_BOUND_FAST;
    build_.struct_size = sizeof build_;
    build_.width = size.width;
    build_.height = size.height;
    build_.converging = query == RSH_QUERY_ANY;
    traverse_.struct_size = sizeof traverse_;
    traverse_.geometry = geometry;
    traverse_.width = size.width;
    traverse_.height = size.height;
    traverse_.query = query;
    traverse_.engine = column.engine;
    bound_.shape = build_.shape = traverse_.shape = column.bound;
    find_sizes();
}

cl::Buffer RshTracer::own(size_t bytes) {
    bytes_ += bytes;
    return cl::Buffer(device_.context(), CL_MEM_READ_WRITE, std::max<size_t>(bytes, 1));
}

// A traversal's scratch memory holds bounds and nodes that are not given: here they will be.
void RshTracer::find_sizes() {
    rsh_sizes bound = empty_sizes(), build = empty_sizes(), traverse = empty_sizes();
    rsh::check(rsh_bound_query(device_.rsh(), &bound_, &bound), "rsh_bound_query");
    rsh::check(rsh_build_query(device_.rsh(), &build_, &build), "rsh_build_query");
    const cl::Buffer stand_in(device_.context(), CL_MEM_READ_WRITE, sizeof(cl_uint));
    traverse_.bounds = traverse_.nodes = stand_in();
    rsh::check(rsh_traverse_query(device_.rsh(), &traverse_, &traverse), "rsh_traverse_query");
    bounds_bytes_ = bound.output_bytes;
    nodes_bytes_ = build.output_bytes;
    // The calls run one after the other, so that one scratch buffer serves all.
    scratch_bytes_ =
        std::max({bound.scratch_bytes, build.scratch_bytes, traverse.scratch_bytes});
}

void RshTracer::set_hit_capacity(cl_ulong hits) {
    traverse_.hit_capacity = hits;
    find_sizes();
}

size_t RshTracer::answer_bytes() const {
    if (traverse_.query == RSH_QUERY_CLOSEST) return size_.pixels() * sizeof(rsh_hit);
    if (traverse_.query == RSH_QUERY_ALL) return traverse_.hit_capacity * sizeof(rsh_hit);
    return size_.pixels() * sizeof(cl_uint);
}

std::vector<NamedBytes> RshTracer::needs() const {
    return {{"the bounds", bounds_bytes_},
            {"the nodes", nodes_bytes_},
            {"the scratch memory", scratch_bytes_},
            {"the hits", answer_bytes()}};
}

void RshTracer::allocate() {
    bounds_ = own(bounds_bytes_);
    nodes_ = own(nodes_bytes_);
    scratch_ = own(scratch_bytes_);
    bound_.bounds = traverse_.bounds = bounds_();
    build_.nodes = traverse_.nodes = nodes_();
    bound_.scratch = build_.scratch = traverse_.scratch = scratch_();
    answers_ = cl::Buffer(device_.context(), CL_MEM_READ_WRITE,
                          std::max(answer_bytes(), sizeof(rsh_hit)));
    (is_shadow()                          ? traverse_.occlusion
     : traverse_.query == RSH_QUERY_COUNT ? traverse_.hit_counts
                                          : traverse_.hits) = answers_();
    if (traverse_.query != RSH_QUERY_ALL) return;
    offsets_ = cl::Buffer(device_.context(), CL_MEM_READ_WRITE,
                          (size_.pixels() + 1) * sizeof(cl_ulong));
    traverse_.hit_offsets = offsets_();
}

void RshTracer::spoil_answers() {
    for (const cl::Buffer& buffer : {answers_, offsets_})
        if (buffer())
            device_.queue().enqueueFillBuffer(buffer, cl_uint{0xa5a5a5a5}, 0,
                                              buffer.getInfo<CL_MEM_SIZE>());
}

FrameTimes RshTracer::trace(const cl::Buffer& rays) {
    build_.rays = traverse_.rays = rays();
    cl::Event bound, build, traverse;
    const cl_command_queue queue = device_.queue()();
    FrameTimes times;
    times.total = milliseconds([&] {
        if (is_shadow())
            device_.queue().enqueueFillBuffer(answers_, cl_uint{0}, 0,
                                              size_.pixels() * sizeof(cl_uint));
        rsh::check(rsh_bound(device_.rsh(), queue, &bound_, 0, nullptr, &bound()), "rsh_bound");
        rsh::check(rsh_build(device_.rsh(), queue, &build_, 0, nullptr, &build()), "rsh_build");
        rsh::check(rsh_traverse(device_.rsh(), queue, &traverse_, 0, nullptr, &traverse()),
                   "rsh_traverse");
        device_.queue().finish();
    });
    if (is_refit_) bound_.mode = RSH_BOUND_REFIT;
    times.build = end_ms(build) - end_ms(bound);
    times.traverse = end_ms(traverse) - end_ms(build);
    times.bound = times.total - times.build - times.traverse;
    return times;
}

double RshTracer::bound() {
    const double ms = milliseconds([&] {
        rsh::check(rsh_bound(device_.rsh(), device_.queue()(), &bound_, 0, nullptr, nullptr),
                   "rsh_bound");
        device_.queue().finish();
    });
    if (is_refit_) bound_.mode = RSH_BOUND_REFIT;
    return ms;
}

void RshTracer::build(const cl::Buffer& rays) {
    build_.rays = rays();
    rsh::check(rsh_build(device_.rsh(), device_.queue()(), &build_, 0, nullptr, nullptr),
               "rsh_build");
    device_.queue().finish();
}

size_t RshTracer::mismatches() const {
    const cl::Buffer found(device_.context(), CL_MEM_READ_WRITE, sizeof(rsh_audit_report));
    rsh_audit_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry = traverse_.geometry;
    desc.ray_count = static_cast<cl_uint>(size_.pixels());
    desc.rays = traverse_.rays;
    desc.query = traverse_.query;
    desc.hits = traverse_.hits;
    desc.occlusion = traverse_.occlusion;
    desc.sample = static_cast<cl_uint>(
        std::clamp(kTests / traverse_.geometry.triangle_count, 64.0, 1024.0));
    desc.report = found();
    rsh::check(rsh_audit(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_audit");
    rsh_audit_report report{};
    device_.queue().enqueueReadBuffer(found, CL_TRUE, 0, sizeof report, &report);
    return report.differences;
}

FrameWork RshTracer::count(const cl::Buffer& rays, size_t active_rays) {
    rsh::check(rsh_count_statistics(device_.rsh(), CL_TRUE), "rsh_count_statistics");
    trace(rays);
    rsh_statistics statistics{};
    statistics.struct_size = sizeof statistics;
    rsh::check(rsh_get_statistics(device_.rsh(), &statistics), "rsh_get_statistics");
    rsh::check(rsh_count_statistics(device_.rsh(), CL_FALSE), "rsh_count_statistics");
    const double tests = double(statistics.node_tests) + double(statistics.ray_tests);
    FrameWork work = {tests / double(std::max<size_t>(active_rays, 1)),
                      statistics.peak_pairs,
                      statistics.launches,
                      {}};
    for (size_t i = 0; i < work.stage_ms.size(); ++i)
        work.stage_ms[i] = 1e-6 * double(statistics.stage_ns[i]);
    return work;
}

template <class T>
std::vector<T> RshTracer::read(const cl::Buffer& buffer, size_t count) const {
    std::vector<T> items(count);
    if (count > 0)
        device_.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(T), items.data());
    return items;
}

std::vector<rsh_hit> RshTracer::hits() const {
    return read<rsh_hit>(answers_, answer_bytes() / sizeof(rsh_hit));
}

std::vector<cl_uint> RshTracer::occlusion() const {
    return read<cl_uint>(answers_, size_.pixels());
}

std::vector<cl_uint> RshTracer::counts() const {
    return read<cl_uint>(answers_, size_.pixels());
}

std::vector<cl_ulong> RshTracer::offsets() const {
    return read<cl_ulong>(offsets_, size_.pixels() + 1);
}

}  // namespace bench
