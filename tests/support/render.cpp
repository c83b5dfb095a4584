// render.cpp - descriptors and buffers of the shading calls and of rsh_frame.
#include "support/render.hpp"

namespace test {

Spawned spawn(const DeviceScene& scene, const std::vector<rsh_ray>& rays,
              const std::vector<rsh_hit>& hits, const SpawnOptions& options) {
    const Buffer<rsh_ray> in_rays(rays), out_rays(rays.size());
    const Buffer<rsh_hit> in_hits(hits);
    const Buffer<cl_float4> in_weights(options.weights), out_weights(rays.size());
    const Buffer<uint32_t> count(std::vector<uint32_t>{1000}), skip(rays.size());
    rsh_spawn_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.scene = &scene.desc;
    desc.kind = options.kind;
    desc.light = options.light;
    desc.ray_count = cl_uint(rays.size());
    desc.rays = in_rays.get();
    desc.hits = in_hits.get();
    desc.weights = options.weights.empty() ? nullptr : in_weights.get();
    desc.min_weight = options.min_weight;
    desc.spawned_rays = out_rays.get();
    desc.spawned_weights = options.kind == RSH_SPAWN_SHADOW ? nullptr : out_weights.get();
    desc.active_count = count.get();
    desc.spawned_skip = options.by_distance ? nullptr : skip.get();
    const rsh_context context = options.context ? options.context : device().rsh;
    RSH_CHECK(rsh_spawn(context, device().queue(), &desc, 0, nullptr, nullptr));
    EXPECT_TRUE(out_rays.guards_intact());
    EXPECT_TRUE(out_weights.guards_intact());
    EXPECT_TRUE(skip.guards_intact());
    return {out_rays.read(), out_weights.read(), count.read()[0] - 1000,
            options.by_distance ? std::vector<uint32_t>{} : skip.read()};
}

std::vector<cl_float4> shade(const DeviceScene& scene, const std::vector<rsh_ray>& rays,
                             const std::vector<rsh_hit>& hits, std::vector<cl_float4> colour,
                             const std::vector<cl_float4>& weights,
                             const std::vector<uint32_t>& occlusion) {
    const Buffer<rsh_ray> in_rays(rays);
    const Buffer<rsh_hit> in_hits(hits);
    const Buffer<cl_float4> in_weights(weights), out(colour);
    const Buffer<uint32_t> masks(occlusion);
    rsh_shade_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.scene = &scene.desc;
    desc.ray_count = cl_uint(rays.size());
    desc.rays = in_rays.get();
    desc.hits = in_hits.get();
    desc.weights = weights.empty() ? nullptr : in_weights.get();
    desc.occlusion = occlusion.empty() ? nullptr : masks.get();
    desc.colour = out.get();
    RSH_CHECK(rsh_shade(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
    EXPECT_TRUE(out.guards_intact());
    return out.read();
}

rsh_camera gallery_camera(uint32_t width, uint32_t height) {
    return look_at({0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, width, height);
}

size_t least_budget(const DeviceScene& scene, const FrameOptions& options) {
    const std::string need = "must be 0 or at least ";
    rsh_frame_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.scene = &scene.desc;
    desc.camera = gallery_camera(options.width, options.height);
    desc.width = options.width;
    desc.height = options.height;
    desc.bounces = options.bounces;
    desc.engine = options.engine;
    desc.strategy = options.strategy;
    desc.tolerance = options.tolerance;
    desc.batches = options.batches;
    desc.budget = 1;
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    EXPECT_EQ(rsh_frame_query(device().rsh, &desc, &sizes), RSH_INVALID_VALUE);
    const std::string error = rsh_last_error();
    const size_t at = error.find(need);
    EXPECT_NE(at, std::string::npos) << error;
    const size_t least = std::stoull(error.substr(at + need.size()));
    desc.budget = least - 1;
    EXPECT_EQ(rsh_frame_query(device().rsh, &desc, &sizes), RSH_INVALID_VALUE);
    desc.budget = least;
    RSH_CHECK(rsh_frame_query(device().rsh, &desc, &sizes));
    EXPECT_LE(sizes.scratch_bytes, least);
    return least;
}

std::vector<cl_float4> frame(const DeviceScene& scene, const FrameOptions& options) {
    const rsh_context context = options.context ? options.context : device().rsh;
    const Buffer<cl_float4> colour(size_t(options.width) * options.height);
    rsh_frame_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.scene = &scene.desc;
    desc.camera =
        options.camera ? *options.camera : gallery_camera(options.width, options.height);
    desc.width = options.width;
    desc.height = options.height;
    desc.bounces = options.bounces;
    desc.min_weight = options.min_weight;
    desc.engine = options.engine;
    desc.strategy = options.strategy;
    desc.budget = options.budget;
    desc.colour = colour.get();
    desc.bounds = options.bounds;
    desc.mode = options.update;
    desc.audit_rays = options.audit_rays;
    desc.audit = options.audit;
    desc.window = options.window;
    desc.tolerance = options.tolerance;
    desc.batches = options.batches;
    std::unique_ptr<Bytes> scratch;
    if (options.own_scratch) {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_frame_query(context, &desc, &sizes));
        scratch = std::make_unique<Bytes>(sizes.scratch_bytes);
        desc.scratch = scratch->get();
    }
    RSH_CHECK(rsh_frame(context, device().queue(), &desc, 0, nullptr, nullptr));
    device().queue.finish();
    EXPECT_TRUE(colour.guards_intact());
    if (scratch) {
        EXPECT_TRUE(scratch->guards_intact());
    }
    return colour.read();
}

Raster rasterize(const DeviceScene& scene, const FrameOptions& options) {
    const size_t pixels = size_t(options.width) * options.height;
    const Buffer<rsh_ray> rays(pixels);
    const Buffer<rsh_hit> hits(pixels);
    rsh_rasterize_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = scene.desc.geometry;
    desc.camera =
        options.camera ? *options.camera : gallery_camera(options.width, options.height);
    desc.width = options.width;
    desc.height = options.height;
    desc.rays = rays.get();
    desc.hits = hits.get();
    RSH_CHECK(rsh_rasterize(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
    return {{rays.read(), options.width, options.height}, hits.read()};
}

}  // namespace test
