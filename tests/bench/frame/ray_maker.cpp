// ray_maker.cpp - rasterize, spawn, and for second bounces traverse and spawn again.
#include "frame/ray_maker.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "frame/diffuse.hpp"
#include "scene/device_structs.hpp"

namespace bench {

bool is_active(const rsh_ray& ray) {
    const cl_float* o = ray.origin_tmin.s;
    const cl_float* d = ray.direction_tmax.s;
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(o[i]) || !std::isfinite(d[i])) return false;
    return (d[0] != 0.0f || d[1] != 0.0f || d[2] != 0.0f) && o[3] <= d[3];
}

const char* name_of(RayKind kind) {
    constexpr const char* kNames[] = {"primary", "reflection", "refraction", "shadow",
                                      "second",  "diffuse",    "shuffled"};
    return kNames[static_cast<int>(kind)];
}

namespace {

cl_uint first_spawn(const SceneOnDevice& scene, RayKind kind) {
    if (kind == RayKind::kShadow) return RSH_SPAWN_SHADOW;
    if (kind == RayKind::kRefraction) return RSH_SPAWN_REFRACTION;
    return kind == RayKind::kSecond && scene.frame_scene().is_glass() ? RSH_SPAWN_REFRACTION
                                                                      : RSH_SPAWN_REFLECTION;
}

}  // namespace

RayMaker::RayMaker(const Device& device, Size size)
    : device_(device),
      size_(size),
      rays_(device.context(), CL_MEM_READ_WRITE, size.pixels() * sizeof(rsh_ray)),
      hits_(device.context(), CL_MEM_READ_WRITE, size.pixels() * sizeof(rsh_hit)),
      spawned_(device.context(), CL_MEM_READ_WRITE, size.pixels() * sizeof(rsh_ray)),
      weights_(device.context(), CL_MEM_READ_WRITE, size.pixels() * sizeof(cl_float4)),
      host_(size.pixels()) {}

std::vector<NamedBytes> RayMaker::needs(Size size) {
    return {{"the rays", size.pixels() * sizeof(rsh_ray)},
            {"the primary hits", size.pixels() * sizeof(rsh_hit)},
            {"the spawned rays", size.pixels() * sizeof(rsh_ray)},
            {"their weights", size.pixels() * sizeof(cl_float4)}};
}

void RayMaker::see(const SceneOnDevice& scene) {
    rsh_rasterize_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry = scene.geometry();
    desc.camera =
        device_camera(scene.frame_scene().camera(), float(size_.width) / float(size_.height));
    desc.width = size_.width;
    desc.height = size_.height;
    desc.rays = rays_();
    desc.hits = hits_();
    rsh::check(rsh_rasterize(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_rasterize");
}

// Leaves the spawned rays in rays_.
void RayMaker::spawn(const SceneOnDevice& scene, cl_uint kind) {
    rsh_spawn_desc desc{};
    desc.struct_size = sizeof desc;
    desc.scene = &scene.scene();
    desc.kind = kind;
    desc.light =
        kind == RSH_SPAWN_SHADOW ? static_cast<cl_uint>(scene.frame_scene().point_light()) : 0;
    desc.ray_count = static_cast<cl_uint>(size_.pixels());
    desc.rays = rays_();
    desc.hits = hits_();
    desc.spawned_rays = spawned_();
    desc.spawned_weights = weights_();
    rsh::check(rsh_spawn(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_spawn");
    std::swap(rays_, spawned_);
}

// Closest hits of rays_ into hits_, with the default engine.
void RayMaker::trace(const SceneOnDevice& scene) {
    rsh_build_desc build{};
    build.struct_size = sizeof build;
    build.rays = rays_();
    build.width = size_.width;
    build.height = size_.height;
    rsh_sizes sizes{};
    sizes.struct_size = sizeof sizes;
    rsh::check(rsh_build_query(device_.rsh(), &build, &sizes), "rsh_build_query");
    const cl::Buffer nodes(device_.context(), CL_MEM_READ_WRITE, sizes.output_bytes);
    build.nodes = nodes();
    rsh::check(rsh_build(device_.rsh(), device_.queue()(), &build, 0, nullptr, nullptr),
               "rsh_build");
    rsh_traverse_desc traverse{};
    traverse.struct_size = sizeof traverse;
    traverse.geometry = scene.geometry();
    traverse.rays = rays_();
    traverse.nodes = nodes();
    traverse.width = size_.width;
    traverse.height = size_.height;
    traverse.hits = hits_();
    rsh::check(rsh_traverse(device_.rsh(), device_.queue()(), &traverse, 0, nullptr, nullptr),
               "rsh_traverse");
    device_.queue().finish();
}

void RayMaker::scatter(const SceneOnDevice& scene) {
    std::vector<rsh_hit> hits(size_.pixels());
    device_.queue().enqueueReadBuffer(hits_, CL_TRUE, 0, hits.size() * sizeof(rsh_hit),
                                      hits.data());
    rays();
    make_diffuse(scene.positions(), scene.frame_scene().mesh().triangles, hits, host_);
    device_.queue().enqueueWriteBuffer(rays_, CL_TRUE, 0, host_.size() * sizeof(rsh_ray),
                                       host_.data());
}

// Always the same order.
void RayMaker::shuffle() {
    rays();
    std::mt19937 random(1);
    std::shuffle(host_.begin(), host_.end(), random);
    device_.queue().enqueueWriteBuffer(rays_, CL_TRUE, 0, host_.size() * sizeof(rsh_ray),
                                       host_.data());
}

void RayMaker::make(const SceneOnDevice& scene, RayKind kind) {
    is_read_ = false;
    see(scene);
    if (kind == RayKind::kDiffuse) return scatter(scene);
    if (kind != RayKind::kPrimary) spawn(scene, first_spawn(scene, kind));
    if (kind == RayKind::kSecond) {
        trace(scene);
        spawn(scene, first_spawn(scene, kind));
    }
    if (kind == RayKind::kShuffled) shuffle();
    device_.queue().finish();
}

const std::vector<rsh_ray>& RayMaker::rays() const {
    if (!is_read_)
        device_.queue().enqueueReadBuffer(rays_, CL_TRUE, 0, host_.size() * sizeof(rsh_ray),
                                          host_.data());
    is_read_ = true;
    return host_;
}

size_t RayMaker::active_count() const {
    return static_cast<size_t>(std::count_if(rays().begin(), rays().end(), is_active));
}

}  // namespace bench
