#include "trace/trace_call.hpp"

#include <cmath>
#include <memory>

namespace test {
namespace {

constexpr uint32_t kAhead = 3, kStride = 5;  // floats, of arrays apart

// Some of the floats of each ray, `stride` floats apart, from the float `first` on; between them canaries.
std::vector<float> spread(const Rays& rays, size_t from, size_t count, size_t first,
                          size_t stride) {
    float canary;
    std::memset(&canary, kCanary, sizeof canary);
    const size_t n = rays.rays.size();
    std::vector<float> floats(n ? first + (n - 1) * stride + count : 1, canary);
    for (size_t i = 0; i < n; ++i) {
        float ray[8];
        std::memcpy(ray, &rays.rays[i], sizeof ray);
        std::copy_n(ray + from, count, floats.begin() + ptrdiff_t(first + i * stride));
    }
    return floats;
}

std::vector<float> six_floats(const Rays& rays) {
    std::vector<float> floats;
    for (const rsh_ray& ray : rays.rays)
        for (const Float3& v : {origin(ray), direction(ray)})
            floats.insert(floats.end(), {v.x, v.y, v.z});
    if (floats.empty()) floats.push_back(0);
    return floats;
}

void expect_guards(const ::testing::AssertionResult& intact, const char* what) {
    EXPECT_TRUE(intact) << what;
}

class Call {
public:
    Call(const DeviceMesh& mesh, const Rays& rays, const TraceWay& way)
        : way_(way), rays_(rays.rays), skip_(rays.skip), masks_(rays.masks) {
        desc.struct_size = sizeof desc;
        desc.geometry = mesh.geometry();
        desc.width = rays.width;
        desc.height = rays.height;
        desc.engine = way.options.engine;
        desc.strategy = way.options.strategy;
        desc.budget = way.options.budget;
        desc.converging = way.options.converging;
        if (!rays.skip.empty()) desc.skip = skip_.get();
        if (!rays.masks.empty()) desc.ray_masks = masks_.get();
        desc.cull = way.options.cull;
        if (way.options.list_count) {
            count_.write({*way.options.list_count});
            desc.list_count = count_.get();
        }
        add_ranges();
        hand_over(rays);
        if (way.options.own_bounds) add_bounds();
    }

    void run() {
        const rsh_context context = way_.options.context ? way_.options.context : device().rsh;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_trace_query(context, &desc, &sizes));
        const Bytes scratch(std::max<size_t>(sizes.scratch_bytes, 1));
        if (way_.options.own_scratch) desc.scratch = scratch.get();
        RSH_CHECK(rsh_trace(context, device().queue(), &desc, 0, nullptr, nullptr));
        device().queue.finish();
        expect_guards(scratch.guards_intact(), "scratch");
    }

    rsh_trace_desc desc = {};

private:
    void add_ranges() {
        if (way_.ranges.empty()) return;
        ranges_ = std::make_unique<Buffer<rsh_mesh_range>>(way_.ranges);
        desc.geometry.ranges = ranges_->get();
        desc.geometry.range_count = cl_uint(way_.ranges.size());
    }

    cl_mem keep(const std::vector<float>& floats) {
        floats_.push_back(std::make_unique<Buffer<float>>(floats));
        return floats_.back()->get();
    }

    void hand_over(const Rays& rays) {
        if (way_.handed == Handed::whole) {
            desc.rays = rays_.get();
        } else if (way_.handed == Handed::interleaved) {
            const cl_mem six = keep(six_floats(rays));
            desc.origins = {six, 0, 24, 0};
            desc.directions = {six, 12, 24, 0};
        } else {
            desc.origins = {keep(spread(rays, 0, 3, 0, 3)), 0, 0, 0};
            desc.directions = {keep(spread(rays, 4, 3, kAhead, kStride)), 4 * kAhead,
                               4 * kStride, 0};
            desc.tmin = {keep(spread(rays, 3, 1, kAhead, 1)), 4 * kAhead, 0, 0};
            desc.tmax = {keep(spread(rays, 7, 1, 0, kStride)), 0, 4 * kStride, 0};
        }
    }

    void add_bounds() {
        rsh_bound_desc bound = {};
        bound.struct_size = sizeof bound;
        bound.geometry = desc.geometry;
        bound.shape = rsh_engine_shape(desc.engine);
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_bound_query(device().rsh, &bound, &sizes));
        bounds_ = std::make_unique<Bytes>(sizes.output_bytes);
        bound.bounds = desc.bounds = bounds_->get();
        RSH_CHECK(rsh_bound(device().rsh, device().queue(), &bound, 0, nullptr, nullptr));
    }

    const TraceWay& way_;
    const Buffer<rsh_ray> rays_;
    const Buffer<uint32_t> skip_;
    const Buffer<uint32_t> masks_;
    const Buffer<uint32_t> count_{1};
    std::vector<std::unique_ptr<Buffer<float>>> floats_;
    std::unique_ptr<Buffer<rsh_mesh_range>> ranges_;
    std::unique_ptr<Bytes> bounds_;
};

}  // namespace

namespace {

// `capacity` hits, and what is asked for of them.
TraceAnswers run_for_hits(Call& call, size_t capacity, const TraceWay& way) {
    const Buffer<rsh_hit> hits(capacity);
    const Buffer<Float3> normals(capacity), points(capacity);
    const Buffer<uint32_t> ids(capacity);
    call.desc.hits = hits.get();
    if (way.normals) call.desc.normals = normals.get();
    if (way.points) call.desc.points = points.get();
    if (!way.ranges.empty()) call.desc.geometry_ids = ids.get();
    call.run();
    expect_guards(hits.guards_intact(), "hits");
    expect_guards(normals.guards_intact(), "normals");
    expect_guards(points.guards_intact(), "points");
    expect_guards(ids.guards_intact(), "ids");
    return {hits.read(), normals.read(), points.read(), ids.read()};
}

}  // namespace

TraceAnswers trace_hits(const DeviceMesh& mesh, const Rays& rays, const TraceWay& way) {
    Call call(mesh, rays, way);
    return run_for_hits(call, rays.rays.size(), way);
}

TraceLists trace_lists(const DeviceMesh& mesh, const Rays& rays, uint64_t capacity,
                       const TraceWay& way) {
    Call call(mesh, rays, way);
    const Buffer<uint64_t> offsets(rays.rays.size() + 1);
    call.desc.query = RSH_QUERY_ALL;
    call.desc.hit_offsets = offsets.get();
    call.desc.hit_capacity = capacity;
    TraceLists lists;
    lists.answers = run_for_hits(call, capacity, way);
    lists.offsets = offsets.read();
    expect_guards(offsets.guards_intact(), "hit_offsets");
    return lists;
}

std::vector<uint32_t> trace_counts(const DeviceMesh& mesh, const Rays& rays,
                                   const TraceWay& way) {
    Call call(mesh, rays, way);
    const Buffer<uint32_t> counts(std::vector<uint32_t>(rays.rays.size(), 0));
    call.desc.query = RSH_QUERY_COUNT;
    call.desc.hit_counts = counts.get();
    call.run();
    expect_guards(counts.guards_intact(), "hit_counts");
    return counts.read();
}

std::vector<uint32_t> trace_occlusion(const DeviceMesh& mesh, const Rays& rays,
                                      const std::vector<uint32_t>& masks, uint32_t bit,
                                      const TraceWay& way) {
    Call call(mesh, rays, way);
    const Buffer<uint32_t> occlusion(masks);
    call.desc.query = RSH_QUERY_ANY;
    call.desc.occlusion = occlusion.get();
    call.desc.occlusion_bit = bit;
    call.run();
    expect_guards(occlusion.guards_intact(), "occlusion");
    return occlusion.read();
}

Rays without_intervals(Rays rays) {
    for (rsh_ray& ray : rays.rays) {
        ray.origin_tmin.s[3] = 0;
        ray.direction_tmax.s[3] = INFINITY;
    }
    return rays;
}

}  // namespace test
