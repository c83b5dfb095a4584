#include "ablation/trace_work.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bench::ablation {
namespace {

constexpr size_t kSample = 512;  // of the first rays, which brute force traces again

test::Mesh soup_of(const test::Mesh& mesh) {
    test::Mesh soup;
    for (const uint32_t index : mesh.indices) soup.vertices.push_back(mesh.vertices[index]);
    return soup;
}

std::vector<float> packed(const std::vector<rsh_ray>& rays) {
    std::vector<float> floats;
    for (const rsh_ray& ray : rays) {
        floats.insert(floats.end(), ray.origin_tmin.s, ray.origin_tmin.s + 3);
        floats.insert(floats.end(), ray.direction_tmax.s, ray.direction_tmax.s + 3);
    }
    return floats;
}

template <class Desc>
Desc with_outputs(Desc desc, const Traced& into) {
    desc.hits = into.hits();
    desc.occlusion = into.occlusion();
    desc.hit_counts = into.counts();
    desc.hit_offsets = into.offsets();
    desc.normals = into.normals();
    desc.geometry_ids = into.ids();
    return desc;
}

}  // namespace

TraceWork::TraceWork(const Device& device, const stability::Scene& scene,
                     const TraceSetup& setup, size_t most_hits)
    : Work(device), setup_(setup), most_hits_(most_hits) {
    desc_ = rsh::make<rsh_trace_desc>();
    place(setup.is_soup ? soup_of(scene.mesh) : scene.mesh);
    const auto count = cl_uint(scene.rays.rays.size());
    desc_.width = setup.is_list ? count : scene.rays.width;
    desc_.height = setup.is_list ? 1 : scene.rays.height;
    place_rays(scene.rays.rays);
    desc_.query = setup.query;
    desc_.engine = RSH_ENGINE_TILES;
    desc_.cull = setup.cull;
    masks_ = upload(setup.masks);
    skip_ = upload(setup.skip);
    if (setup.has_list_count) list_count_ = upload(std::vector<cl_uint>{count});
    desc_.ray_masks = masks_();
    desc_.skip = skip_();
    desc_.list_count = list_count_();
    if (setup.query == RSH_QUERY_ALL) desc_.hit_capacity = most_hits;
    traced_ = outputs_for(count, [this](size_t bytes) { return buffer(bytes); });
    desc_ = with_outputs(desc_, traced_);
    scratch_ = scratch_of(rsh_trace_query, desc_);
    desc_.scratch = scratch_();
}

void TraceWork::place(const test::Mesh& mesh) {
    vertices_ = upload(mesh.vertices);
    indices_ = upload(mesh.indices);
    ranges_ = upload(setup_.ranges);
    desc_.geometry.vertices = vertices_();
    desc_.geometry.vertex_count = cl_uint(mesh.vertices.size());
    desc_.geometry.indices = indices_();
    desc_.geometry.triangle_count = mesh.triangle_count();
    desc_.geometry.ranges = ranges_();
    desc_.geometry.range_count = cl_uint(setup_.ranges.size());
}

void TraceWork::place_rays(const std::vector<rsh_ray>& rays) {
    if (!setup_.is_packed) {
        ray_buffer_ = upload(rays);
        desc_.rays = ray_buffer_();
        return;
    }
    constexpr cl_uint kStride = 6 * sizeof(float);
    ray_buffer_ = upload(packed(rays));
    desc_.origins = {ray_buffer_(), 0, kStride, 0};
    desc_.directions = {ray_buffer_(), kStride / 2, kStride, 0};
}

Traced TraceWork::outputs_for(size_t rays,
                              const std::function<cl::Buffer(size_t)>& make) const {
    Traced into;
    const bool lists = setup_.query == RSH_QUERY_ALL;
    const size_t hits = lists ? most_hits_ : rays;
    if (lists || setup_.query == RSH_QUERY_CLOSEST) into.hits = make(hits * sizeof(rsh_hit));
    if (setup_.query == RSH_QUERY_ANY) into.occlusion = make(rays * sizeof(cl_uint));
    if (setup_.query == RSH_QUERY_COUNT) into.counts = make(rays * sizeof(cl_uint));
    if (lists) into.offsets = make((rays + 1) * sizeof(cl_ulong));
    if (setup_.has_normals) into.normals = make(hits * 3 * sizeof(float));
    if (setup_.has_ids) into.ids = make(hits * sizeof(cl_uint));
    return into;
}

// A mask per ray grows by bits, so it is made 0 first, as a caller does.
void TraceWork::trace(rsh_context context, const rsh_trace_desc& desc) const {
    const size_t rays = size_t{desc.width} * desc.height;
    if (desc.occlusion)
        queue_.enqueueFillBuffer(cl::Buffer(desc.occlusion, true), cl_uint{0}, 0,
                                 rays * sizeof(cl_uint));
    rsh::check(rsh_trace(context, queue_(), &desc, 0, nullptr, nullptr), "rsh_trace");
    queue_.finish();
}

void TraceWork::prepare(rsh_context context) const {
    rsh_prepare_desc prepared = rsh::make<rsh_prepare_desc>();
    prepared.trace = &desc_;
    rsh::check(rsh_prepare(context, &prepared), "rsh_prepare");
}

void TraceWork::run(rsh_context context) {
    trace(context, desc_);
}

std::vector<uint8_t> TraceWork::answer_of(const Traced& traced, size_t rays) const {
    std::vector<uint8_t> all;
    size_t hits = rays;
    if (traced.offsets()) {
        append(traced.offsets, (rays + 1) * sizeof(cl_ulong), all);
        cl_ulong end = 0;
        std::copy_n(all.end() - sizeof end, sizeof end, reinterpret_cast<uint8_t*>(&end));
        hits = std::min<size_t>(end, most_hits_);
    }
    const auto add = [&](const cl::Buffer& from, size_t bytes) {
        if (from()) append(from, bytes, all);
    };
    add(traced.hits, hits * sizeof(rsh_hit));
    add(traced.occlusion, rays * sizeof(cl_uint));
    add(traced.counts, rays * sizeof(cl_uint));
    add(traced.normals, hits * 3 * sizeof(float));
    add(traced.ids, hits * sizeof(cl_uint));
    return all;
}

bool TraceWork::is_right(rsh_context context) const {
    rsh_trace_desc sample = desc_;
    const size_t rays = std::min(kSample, size_t{desc_.width} * desc_.height);
    sample.width = cl_uint(rays);
    sample.height = 1;
    sample.engine = RSH_ENGINE_BRUTE_FORCE;
    const Traced expected = outputs_for(rays, [this](size_t bytes) {
        return cl::Buffer(device_.context(), CL_MEM_READ_WRITE, bytes);
    });
    sample = with_outputs(sample, expected);
    rsh_sizes sizes = rsh::make<rsh_sizes>();
    rsh::check(rsh_trace_query(context, &sample, &sizes), "rsh_trace_query");
    cl::Buffer scratch;
    if (sizes.scratch_bytes)
        scratch = cl::Buffer(device_.context(), CL_MEM_READ_WRITE, sizes.scratch_bytes);
    sample.scratch = scratch();
    trace(context, sample);
    return answer_of(traced_, rays) == answer_of(expected, rays);
}

std::string TraceWork::programs() const {
    return fmt::format("trace query:{} filter:{} packed:{} described:{} list:{}", setup_.query,
                       !setup_.masks.empty() || setup_.cull != RSH_CULL_NONE, setup_.is_packed,
                       setup_.has_normals || setup_.has_ids, setup_.is_list);
}

}  // namespace bench::ablation
