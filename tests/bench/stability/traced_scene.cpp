#include "stability/traced_scene.hpp"

#include "frame/frame_rows.hpp"
#include "upload.hpp"

namespace bench::stability {
namespace {

const std::vector<test::Float3>& largest(const Scene& scene) {
    const auto* largest = &scene.mesh.vertices;
    for (const auto& frame : scene.earlier)
        if (frame.size() > largest->size()) largest = &frame;
    return *largest;
}

}  // namespace

TracedScene::TracedScene(const Device& device, const Scene& scene)
    : device_(device),
      size_{scene.rays.width, scene.rays.height},
      is_converging_(scene.is_converging),
      frames_(scene.earlier),
      vertices_(upload(device, largest(scene))),
      indices_(upload(device, scene.mesh.indices)),
      rays_(upload(device, scene.rays.rays)),
      skip_(upload(device, scene.rays.skip)) {
    frames_.push_back(scene.mesh.vertices);
    largest_ = geometry_of(largest(scene).size());
    if (indices_()) largest_.triangle_count = scene.mesh.triangle_count();
}

rsh_geometry TracedScene::geometry_of(size_t vertex_count) const {
    rsh_geometry geometry{};
    geometry.vertices = vertices_();
    geometry.vertex_count = static_cast<cl_uint>(vertex_count);
    geometry.indices = indices_();
    geometry.triangle_count =
        indices_() ? largest_.triangle_count : static_cast<cl_uint>(vertex_count / 3);
    return geometry;
}

void TracedScene::show(const std::vector<test::Float3>& vertices, RshTracer& tracer) const {
    if (!vertices.empty())
        device_.queue().enqueueWriteBuffer(
            vertices_, CL_TRUE, 0, vertices.size() * sizeof vertices[0], vertices.data());
    tracer.set_geometry(geometry_of(vertices.size()));
}

RshTracer TracedScene::tracer(const Column& column, bool is_list, cl_uint query,
                              cl_ulong capacity) const {
    const Size size = is_list ? Size{static_cast<cl_uint>(size_.pixels()), 1} : size_;
    Column kept = column;
    kept.is_refit = frames_.size() > 1;
    RshTracer tracer(device_, largest_, size, query, kept);
    if (query == RSH_QUERY_ALL) tracer.set_hit_capacity(capacity);
    tracer.allocate();
    tracer.set_converging(is_converging_);
    tracer.set_skip(skip_);
    return tracer;
}

RshTracer TracedScene::traced(const Column& column, bool is_list, cl_uint query,
                              cl_ulong capacity) const {
    RshTracer tracer = this->tracer(column, is_list, query, capacity);
    for (const auto& frame : frames_) {
        if (frames_.size() > 1) show(frame, tracer);
        tracer.spoil_answers();
        tracer.trace(rays_);
    }
    return tracer;
}

std::vector<rsh_hit> TracedScene::closest(const Column& column, bool is_list) const {
    return traced(column, is_list, RSH_QUERY_CLOSEST).hits();
}

std::vector<cl_uint> TracedScene::any(const Column& column, bool is_list) const {
    return traced(column, is_list, RSH_QUERY_ANY).occlusion();
}

std::vector<cl_uint> TracedScene::counts(const Column& column, bool is_list) const {
    return traced(column, is_list, RSH_QUERY_COUNT).counts();
}

AllHits TracedScene::all(const Column& column, bool is_list, cl_ulong capacity) const {
    const RshTracer tracer = traced(column, is_list, RSH_QUERY_ALL, capacity);
    AllHits all = {tracer.offsets(), {}};
    const cl_ulong count = all.offsets.back();
    if (count > capacity) return this->all(column, is_list, count);
    all.hits = tracer.hits();
    all.hits.resize(count);
    return all;
}

std::vector<Column> engines(const Device& device) {
    std::vector<Column> all = {{RSH_ENGINE_BRUTE_FORCE, RSH_SHAPE_DEFAULT,
                                rsh_engine_name(RSH_ENGINE_BRUTE_FORCE), "none"}};
    for (const Column& column : frame_columns(device))
        if (!column.is_refit) all.push_back(column);
    return all;
}

}  // namespace bench::stability
