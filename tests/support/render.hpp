// render.hpp - the shading calls and whole frames over a test scene, read back.
#pragma once

#include <vector>

#include "support/device_scene.hpp"
#include "support/rays.hpp"

namespace test {

struct Spawned {
    std::vector<rsh_ray> rays;
    std::vector<cl_float4> weights;  // not for shadow
    uint32_t active = 0;             // as counted on the device
    std::vector<uint32_t> skip;      // empty: not asked for
};

struct SpawnOptions {
    uint32_t kind = RSH_SPAWN_REFLECTION;
    uint32_t light = 0;
    float min_weight = 0;
    std::vector<cl_float4> weights;  // empty: all 1
    bool by_distance = false;        // keeps rays off their triangle without its number
    rsh_context context = nullptr;   // null: the device's
};

Spawned spawn(const DeviceScene& scene, const std::vector<rsh_ray>& rays,
              const std::vector<rsh_hit>& hits, const SpawnOptions& options);

// Adds to `colour`; `weights` and `occlusion` may be empty.
std::vector<cl_float4> shade(const DeviceScene& scene, const std::vector<rsh_ray>& rays,
                             const std::vector<rsh_hit>& hits, std::vector<cl_float4> colour,
                             const std::vector<cl_float4>& weights = {},
                             const std::vector<uint32_t>& occlusion = {});

struct FrameOptions {
    uint32_t width = 64, height = 48;
    const rsh_camera* camera = nullptr;  // null: the gallery's
    uint32_t bounces = 0;
    float min_weight = 0;
    cl_uint engine = RSH_ENGINE_DEFAULT;
    cl_uint strategy = RSH_STRATEGY_DEFAULT;
    size_t budget = 0;
    bool own_scratch = false;
    rsh_context context = nullptr;  // null: the device's
    cl_mem bounds = nullptr;
    cl_uint update = 0;
    cl_uint audit_rays = 0;
    cl_mem audit = nullptr;
    rsh_window window = {};
    float tolerance = 0;
    const rsh_batch_source* batches = nullptr;
};

// The gallery's camera.
rsh_camera gallery_camera(uint32_t width, uint32_t height);

// The least budget that rsh_frame takes, as its error names it.
size_t least_budget(const DeviceScene& scene, const FrameOptions& options);

std::vector<cl_float4> frame(const DeviceScene& scene, const FrameOptions& options);

// What the camera of a frame sees.
struct Raster {
    Rays rays;
    std::vector<rsh_hit> hits;
};
Raster rasterize(const DeviceScene& scene, const FrameOptions& options);

}  // namespace test
