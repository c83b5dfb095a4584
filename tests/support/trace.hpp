// trace.hpp - the ray calls of rsh over host data: upload, call, wait, check the guards, read
// back.
#pragma once

#include <cstring>
#include <functional>
#include <optional>
#include <vector>

#include "bvh/layout.hpp"
#include "rays/types.h"
#include "support/buffer.hpp"
#include "support/cases.hpp"
#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace test {

// A mesh on the device, in an ordinary layout: packed vertices, offset 0.
class DeviceMesh {
public:
    explicit DeviceMesh(const Mesh& mesh);
    const rsh_geometry& geometry() const { return geometry_; }
    // Its triangles are several meshes from now on.
    void divide(const std::vector<rsh_mesh_range>& ranges);
    // So many, the first ones, count as standing still from now on.
    void stand_still(uint32_t triangles) { geometry_.still_triangles = triangles; }

private:
    Buffer<Float3> vertices_;
    std::optional<Buffer<uint32_t>> indices_;
    std::optional<Buffer<rsh_mesh_range>> ranges_;
    rsh_geometry geometry_ = {};
};

struct Hierarchy {
    ray_levels levels;
    std::vector<cone_node4> quads;
};

// rsh_build of cones over the rays, read back.
Hierarchy build(const Rays& rays);

// rsh_build with any bound, read back; `nodes` as they lie in memory.
struct BuiltNodes {
    ray_levels levels;
    std::vector<uint8_t> bytes;
};
BuiltNodes build_nodes(const Rays& rays, cl_uint bound, bool converging);

template <class Node>
std::vector<Node> nodes_of(const BuiltNodes& built) {
    std::vector<Node> nodes(built.bytes.size() / sizeof(Node));
    std::memcpy(nodes.data(), built.bytes.data() + sizeof(nodes_head),
                nodes.size() * sizeof(Node));
    return nodes;
}

// Of the shape `box`: the rays by their places, see ray_levels.
struct RayOrder {
    bool is_sorted;
    std::vector<uint32_t> rays;
};
RayOrder ray_order(const BuiltNodes& built);

// Spheres of the shape `cone`.
std::vector<cl_float4> bound(const DeviceMesh& mesh);
// What rsh_bound makes for the shape `box`, see bvh/layout.h.
struct SceneBvh {
    std::vector<bvh_leaf> leaves;
    std::vector<bvh_node> nodes;
    std::vector<uint32_t> order;  // triangle numbers
    bvh_head head;

    uint32_t top() const { return head.nodes[RSH_MOVING_TREE].end - 1; }
};
SceneBvh build_bvh(const DeviceMesh& mesh);
// The same after each frame: as many triangles in each; all but the first are refits.
std::vector<SceneBvh> refitted_bvhs(const std::vector<const DeviceMesh*>& frames);
// The first is made to be kept.
std::vector<SceneBvh> kept_bvhs(const std::vector<const DeviceMesh*>& frames);
// Of a refit of bounds that hold nothing but this byte.
SceneBvh bvh_refitted_from(const DeviceMesh& mesh, uint8_t byte);

struct TraceOptions {
    cl_uint engine = RSH_ENGINE_DEFAULT;
    cl_uint bound = RSH_SHAPE_DEFAULT;  // what the engine prefers
    cl_uint strategy = RSH_STRATEGY_DEFAULT;
    size_t budget = 0;
    bool own_scratch = false;  // the caller's scratch instead of the context's pool
    bool own_bounds = false;   // from rsh_bound instead of made in scratch
    std::vector<const DeviceMesh*> earlier = {};  // own bounds were kept over these
    bool converging = false;                      // nodes bound the rays from t = 1
    std::function<void()> before_batch = {};      // called on this thread
    rsh_context context = nullptr;                // null: the device's
    cl_mem tests_per_ray = nullptr;
    cl_uint cull = RSH_CULL_NONE;
    std::optional<uint32_t> list_count = {};   // tells the device, not the host, of so many
    std::optional<uint32_t> nodes_count = {};  // the same for the nodes; none: the same
};

std::vector<rsh_hit> closest_hits(const DeviceMesh& mesh, const Rays& rays,
                                  const TraceOptions& options = {});

// What that counts, and nothing else.
rsh_statistics statistics_of(const DeviceMesh& mesh, const Rays& rays, TraceOptions options);

// Masks with bit `bit` set where something is hit; all other bits start as in `masks`.
std::vector<uint32_t> occlusion(const DeviceMesh& mesh, const Rays& rays,
                                std::vector<uint32_t> masks, uint32_t bit,
                                const TraceOptions& options = {});

// The number of triangles that each ray crosses; counts of rays that there are not, see list_count,
// stay as in `before`.
std::vector<uint32_t> hit_counts(const DeviceMesh& mesh, const Rays& rays,
                                 const TraceOptions& options = {}, uint32_t before = 0);

// All hits: offsets has one number more than there are rays.
struct HitLists {
    std::vector<uint64_t> offsets;
    std::vector<rsh_hit> hits;  // as many as there was room for
};
HitLists hit_lists(const DeviceMesh& mesh, const Rays& rays, uint64_t capacity,
                   const TraceOptions& options = {});
// With room for all of them.
HitLists all_hits(const DeviceMesh& mesh, const Rays& rays, const TraceOptions& options = {});

}  // namespace test
