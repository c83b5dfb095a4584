// valid_calls.hpp - one valid descriptor per call over small shared buffers: a misuse test
// breaks one field of it. Output buffers hold canaries, so that a call that enqueued anything
// shows.
#pragma once

#include "batches/scene_source.hpp"
#include "rays/types.h"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace test {

constexpr uint32_t kSide = 8;
constexpr uint32_t kRays = kSide * kSide;

struct ValidCalls {
    Scene host = gallery();
    DeviceScene scene{host};
    SceneSource source{host, host.mesh.triangle_count() / 2 + 1, false};  // in two batches
    rsh_scene batched = scene_of_batches();
    Rays ray_list = pinhole_rays(kSide, kSide);
    Buffer<rsh_ray> rays{ray_list.rays};
    Buffer<rsh_ray> out_rays{kRays};
    Buffer<rsh_hit> in_hits{std::vector<rsh_hit>(kRays, rsh_hit{1, 0, 0, 0})};
    Buffer<rsh_hit> hits{kRays};
    Buffer<rsh_surface> surfaces{kRays};
    Buffer<uint32_t> branches{2 * kRays};
    Buffer<uint32_t> in_branches{std::vector<uint32_t>(2 * kRays, RSH_NO_RAY)};
    Buffer<uint32_t> spawned_count{2};
    Buffer<uint32_t> in_spawned_count{std::vector<uint32_t>(2, 0)};
    Buffer<uint32_t> occlusion{kRays};
    Buffer<cl_float4> colour{kRays};
    Buffer<cl_float4> weights{kRays};
    Buffer<uint8_t> bounds{64 * host.mesh.triangle_count() + 65536};  // enough for any shape
    Buffer<uint8_t> nodes{64 * sizeof(cone_node4)};
    Buffer<uint32_t> words{std::vector<uint32_t>(1024, 7)};
    Buffer<uint8_t> flags{std::vector<uint8_t>(1024, 1)};
    Buffer<uint32_t> packed{1024};
    Buffer<uint32_t> count{1};
    Buffer<rsh_audit_report> report{1};

    rsh_rasterize_desc rasterize() const;
    rsh_bound_desc bound() const;
    rsh_build_desc build() const;
    rsh_traverse_desc traverse() const;  // brute force: needs no nodes
    rsh_trace_desc trace() const;        // likewise
    rsh_audit_desc audit() const;
    rsh_spawn_desc spawn() const;
    rsh_spawn_wave_desc spawn_wave() const;
    rsh_gather_wave_desc gather_wave() const;
    rsh_shadow_desc shadow() const;
    rsh_find_surfaces_desc find_surfaces() const;
    rsh_shade_desc shade() const;
    rsh_frame_desc frame() const;
    // Of a scene in batches.
    rsh_trace_desc trace_batches() const;
    rsh_frame_desc frame_batches() const;
    rsh_reduce_desc reduce() const;

    // No output buffer was written.
    ::testing::AssertionResult outputs_untouched() const;

private:
    rsh_scene scene_of_batches() const;
};

}  // namespace test
