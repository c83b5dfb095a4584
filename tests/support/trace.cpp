// trace.cpp - descriptors, buffers and waiting, once for all tests.
#include "support/trace.hpp"
#include "bvh/types.h"
#include "rays/levels.hpp"
#include "rays/types.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>

namespace test {
namespace {

void expect_guards(const ::testing::AssertionResult& result, const char* buffer) {
    EXPECT_TRUE(result) << "of the buffer " << buffer;
}

// Everything that one traversal reads, besides its output.
class Traversal {
public:
    Traversal(const DeviceMesh& mesh, const Rays& rays, const TraceOptions& options)
        : rays_(rays.rays),
          skip_(rays.skip),
          masks_(rays.masks),
          context_(options.context ? options.context : device().rsh) {
        desc.struct_size = sizeof desc;
        desc.geometry = mesh.geometry();
        desc.rays = rays_.get();
        desc.skip = rays.skip.empty() ? nullptr : skip_.get();
        desc.ray_masks = rays.masks.empty() ? nullptr : masks_.get();
        desc.cull = options.cull;
        desc.tests_per_ray = options.tests_per_ray;
        desc.width = rays.width;
        desc.height = rays.height;
        desc.engine = options.engine;
        desc.shape = options.bound ? options.bound : rsh_engine_shape(options.engine);
        desc.strategy = options.strategy;
        desc.budget = options.budget;
        if (options.engine != RSH_ENGINE_BRUTE_FORCE) {
            take_count(options.nodes_count ? options.nodes_count : options.list_count);
            add_nodes(options.converging);
        }
        take_count(options.list_count);
        if (options.own_bounds) add_bounds(mesh, options.earlier);
        own_scratch_ = options.own_scratch;
        before_batch_ = options.before_batch;
        desc.progress_user = this;
        if (before_batch_)
            desc.progress = [](cl_uint, cl_uint, void* self) {
                static_cast<Traversal*>(self)->before_batch_();
                return 0;
            };
    }

    void run() {
        if (own_scratch_) {
            rsh_sizes sizes = {};
            sizes.struct_size = sizeof sizes;
            RSH_CHECK(rsh_traverse_query(context_, &desc, &sizes));
            scratch_ = std::make_unique<Bytes>(sizes.scratch_bytes);
            desc.scratch = scratch_->get();
        }
        RSH_CHECK(rsh_traverse(context_, device().queue(), &desc, 0, nullptr, nullptr));
        device().queue.finish();
        if (scratch_) expect_guards(scratch_->guards_intact(), "scratch");
        if (nodes_) expect_guards(nodes_->guards_intact(), "nodes");
        if (bounds_) expect_guards(bounds_->guards_intact(), "bounds");
    }

    rsh_traverse_desc desc = {};

private:
    void take_count(const std::optional<uint32_t>& count) {
        if (!count) return;
        count_.write({*count});
        desc.list_count = count_.get();
    }

    void add_nodes(bool converging) {
        rsh_build_desc build = {};
        build.struct_size = sizeof build;
        build.rays = desc.rays;
        build.width = desc.width;
        build.height = desc.height;
        build.converging = converging;
        build.shape = desc.shape;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_build_query(context_, &build, &sizes));
        nodes_ = std::make_unique<Bytes>(sizes.output_bytes);
        build.nodes = desc.nodes = nodes_->get();
        RSH_CHECK(rsh_build(context_, device().queue(), &build, 0, nullptr, nullptr));
        if (!desc.list_count) return;
        build.list_count = desc.list_count;  // over the nodes of the longer list
        RSH_CHECK(rsh_build(context_, device().queue(), &build, 0, nullptr, nullptr));
    }

    void add_bounds(const DeviceMesh& mesh, std::vector<const DeviceMesh*> frames) {
        const bool is_kept = !frames.empty();
        frames.push_back(&mesh);
        rsh_bound_desc bound = {};
        bound.struct_size = sizeof bound;
        bound.shape = desc.shape;
        size_t bytes = 0;
        for (const DeviceMesh* frame : frames) {
            bound.geometry = frame->geometry();
            rsh_sizes sizes = {};
            sizes.struct_size = sizeof sizes;
            RSH_CHECK(rsh_bound_query(context_, &bound, &sizes));
            bytes = std::max(bytes, sizes.output_bytes);
        }
        bounds_ = std::make_unique<Bytes>(bytes);
        bound.bounds = desc.bounds = bounds_->get();
        bound.mode = is_kept ? RSH_BOUND_QUALITY : RSH_BOUND_FAST;
        for (const DeviceMesh* frame : frames) {
            bound.geometry = frame->geometry();
            RSH_CHECK(rsh_bound(context_, device().queue(), &bound, 0, nullptr, nullptr));
            bound.mode = RSH_BOUND_REFIT;
        }
    }

    Buffer<rsh_ray> rays_;
    Buffer<uint32_t> skip_;
    Buffer<uint32_t> masks_;
    Buffer<uint32_t> count_{1};
    rsh_context context_;
    bool own_scratch_ = false;
    std::function<void()> before_batch_;
    std::unique_ptr<Bytes> nodes_, bounds_, scratch_;
};

}  // namespace

DeviceMesh::DeviceMesh(const Mesh& mesh) : vertices_(mesh.vertices) {
    geometry_.vertices = vertices_.get();
    geometry_.vertex_count = cl_uint(mesh.vertices.size());
    geometry_.triangle_count = mesh.triangle_count();
    if (mesh.indices.empty()) return;
    indices_.emplace(mesh.indices);
    geometry_.indices = indices_->get();
}

void DeviceMesh::divide(const std::vector<rsh_mesh_range>& ranges) {
    ranges_.emplace(ranges);
    geometry_.ranges = ranges_->get();
    geometry_.range_count = cl_uint(ranges.size());
}

BuiltNodes build_nodes(const Rays& rays, cl_uint bound, bool converging) {
    const Buffer<rsh_ray> input(rays.rays);
    rsh_build_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.rays = input.get();
    desc.width = rays.width;
    desc.height = rays.height;
    desc.converging = converging;
    desc.shape = bound;
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    BuiltNodes made;
    RSH_CHECK(rsh_build_query(device().rsh, &desc, &sizes));
    made.levels = bound == RSH_SHAPE_CONE ? rsh::cone_levels(desc.width, desc.height)
                                          : rsh::box_levels(desc.width, desc.height);
    const Buffer<uint8_t> nodes(sizes.output_bytes);
    const Buffer<uint8_t> scratch(std::max<size_t>(sizes.scratch_bytes, 1));
    desc.nodes = nodes.get();
    desc.scratch = scratch.get();
    RSH_CHECK(rsh_build(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
    made.bytes = nodes.read();
    expect_guards(nodes.guards_intact(), "nodes");
    expect_guards(scratch.guards_intact(), "scratch");
    return made;
}

RayOrder ray_order(const BuiltNodes& built) {
    const ray_levels& l = built.levels;
    const size_t tiles = size_t(l.width[2]) * l.height[2],
                 count = size_t(l.width[0]) * l.height[0];
    nodes_head head;
    std::memcpy(&head, built.bytes.data(), sizeof head);
    RayOrder order = {head.order_at != 0, std::vector<uint32_t>(count)};
    std::iota(order.rays.begin(), order.rays.end(), 0u);
    if (!order.is_sorted) return order;
    EXPECT_EQ(head.order_at, RSH_RAY_ORDER_AT(tiles));
    std::memcpy(order.rays.data(), built.bytes.data() + 4 * size_t{head.order_at}, 4 * count);
    return order;
}

Hierarchy build(const Rays& rays) {
    const BuiltNodes made = build_nodes(rays, RSH_SHAPE_CONE, false);
    return {made.levels, nodes_of<cone_node4>(made)};
}

namespace {

// rsh_bound into one buffer, frame by frame.
template <class T>
class BoundFrames {
public:
    BoundFrames(const DeviceMesh& mesh, cl_uint bound) {
        desc_.struct_size = sizeof desc_;
        desc_.geometry = mesh.geometry();
        desc_.shape = bound;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_bound_query(device().rsh, &desc_, &sizes));
        bounds_ = std::make_unique<Buffer<T>>(sizes.output_bytes / sizeof(T));
        desc_.bounds = bounds_->get();
    }

    void fill(const T& item) const { bounds_->write(std::vector<T>(bounds_->count(), item)); }

    std::vector<T> bound(const DeviceMesh& mesh, cl_uint update) {
        desc_.geometry = mesh.geometry();
        desc_.mode = update;
        RSH_CHECK(rsh_bound(device().rsh, device().queue(), &desc_, 0, nullptr, nullptr));
        expect_guards(bounds_->guards_intact(), "bounds");
        return bounds_->read();
    }

private:
    rsh_bound_desc desc_ = {};
    std::unique_ptr<Buffer<T>> bounds_;
};

// Of triangles that all move.
SceneBvh scene_bvh(const std::vector<uint32_t>& words, const rsh_geometry& geometry) {
    const bvh_layout layout = rsh::bvh_layouts_of(geometry)[RSH_MOVING_TREE];
    SceneBvh made;
    const uint32_t* at = words.data();
    const auto take = [&at](auto& items, size_t count) {
        items.resize(count);
        if (count) std::memcpy(items.data(), at, count * sizeof(items[0]));
        at += count * sizeof(items[0]) / sizeof *at;
    };
    std::memcpy(&made.head, at, sizeof made.head);
    at += sizeof made.head / sizeof *at;
    take(made.leaves, RSH_LEAVES(layout));
    take(made.nodes, RSH_NODES(layout));
    take(made.order, geometry.triangle_count);
    return made;
}

std::vector<SceneBvh> bvhs_of(const std::vector<const DeviceMesh*>& frames, cl_uint first) {
    BoundFrames<uint32_t> bounds(*frames[0], RSH_SHAPE_BOX);
    std::vector<SceneBvh> made;
    for (const DeviceMesh* mesh : frames)
        made.push_back(
            scene_bvh(bounds.bound(*mesh, made.empty() ? first : cl_uint{RSH_BOUND_REFIT}),
                      mesh->geometry()));
    return made;
}

}  // namespace

std::vector<cl_float4> bound(const DeviceMesh& mesh) {
    std::vector<cl_float4> made =
        BoundFrames<cl_float4>(mesh, RSH_SHAPE_CONE).bound(mesh, RSH_BOUND_FAST);
    made.erase(made.begin(), made.begin() + sizeof(spheres_head) / sizeof(cl_float4));
    return made;
}

SceneBvh build_bvh(const DeviceMesh& mesh) {
    return refitted_bvhs({&mesh})[0];
}

std::vector<SceneBvh> refitted_bvhs(const std::vector<const DeviceMesh*>& frames) {
    return bvhs_of(frames, RSH_BOUND_FAST);
}

std::vector<SceneBvh> kept_bvhs(const std::vector<const DeviceMesh*>& frames) {
    return bvhs_of(frames, RSH_BOUND_QUALITY);
}

SceneBvh bvh_refitted_from(const DeviceMesh& mesh, uint8_t byte) {
    BoundFrames<uint32_t> bounds(mesh, RSH_SHAPE_BOX);
    bounds.fill(0x01010101u * byte);
    return scene_bvh(bounds.bound(mesh, RSH_BOUND_REFIT), mesh.geometry());
}

std::vector<rsh_hit> closest_hits(const DeviceMesh& mesh, const Rays& rays,
                                  const TraceOptions& options) {
    Traversal traversal(mesh, rays, options);
    const Buffer<rsh_hit> hits(rays.rays.size());
    traversal.desc.query = RSH_QUERY_CLOSEST;
    traversal.desc.hits = hits.get();
    traversal.run();
    expect_guards(hits.guards_intact(), "hits");
    return hits.read();
}

rsh_statistics statistics_of(const DeviceMesh& mesh, const Rays& rays, TraceOptions options) {
    const OwnContext own;
    if (!options.context) options.context = own.get();
    RSH_CHECK(rsh_count_statistics(options.context, CL_TRUE));
    closest_hits(mesh, rays, options);
    rsh_statistics counted = {};
    counted.struct_size = sizeof counted;
    RSH_CHECK(rsh_get_statistics(options.context, &counted));
    return counted;
}

std::vector<uint32_t> occlusion(const DeviceMesh& mesh, const Rays& rays,
                                std::vector<uint32_t> masks, uint32_t bit,
                                const TraceOptions& options) {
    Traversal traversal(mesh, rays, options);
    const Buffer<uint32_t> buffer(masks);
    traversal.desc.query = RSH_QUERY_ANY;
    traversal.desc.occlusion = buffer.get();
    traversal.desc.occlusion_bit = bit;
    traversal.run();
    expect_guards(buffer.guards_intact(), "occlusion");
    return buffer.read();
}

std::vector<uint32_t> hit_counts(const DeviceMesh& mesh, const Rays& rays,
                                 const TraceOptions& options, uint32_t before) {
    Traversal traversal(mesh, rays, options);
    const Buffer<uint32_t> counts(std::vector<uint32_t>(rays.rays.size(), before));
    traversal.desc.query = RSH_QUERY_COUNT;
    traversal.desc.hit_counts = counts.get();
    traversal.run();
    expect_guards(counts.guards_intact(), "hit_counts");
    return counts.read();
}

HitLists hit_lists(const DeviceMesh& mesh, const Rays& rays, uint64_t capacity,
                   const TraceOptions& options) {
    Traversal traversal(mesh, rays, options);
    const Buffer<uint64_t> offsets(rays.rays.size() + 1);
    const Buffer<rsh_hit> hits(capacity);
    traversal.desc.query = RSH_QUERY_ALL;
    traversal.desc.hit_offsets = offsets.get();
    traversal.desc.hit_capacity = capacity;
    traversal.desc.hits = hits.get();
    traversal.run();
    expect_guards(offsets.guards_intact(), "hit_offsets");
    expect_guards(hits.guards_intact(), "hits");
    return {offsets.read(), hits.read()};
}

HitLists all_hits(const DeviceMesh& mesh, const Rays& rays, const TraceOptions& options) {
    return hit_lists(mesh, rays, hit_lists(mesh, rays, 0, options).offsets.back(), options);
}

}  // namespace test
