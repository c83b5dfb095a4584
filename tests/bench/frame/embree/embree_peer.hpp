// embree_peer.hpp - Embree 3 on the same triangles and rays: rebuilt or refitted per frame,
// then traced in packets of neighbouring rays, in parallel, with as many threads as the OpenCL
// device has compute units. Written as its users would write it for geometry that moves every
// frame: vertex and index buffers shared, scene flag dynamic, denormals flushed. Its default mode
// is not robust.
#pragma once

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <memory>

#include "frame/ray_maker.hpp"

namespace bench {

enum class EmbreeBuild { kLow, kMedium, kRefit };

const char* name_of(EmbreeBuild build);

// Width of the packets (1, 8 or 16) and what the context's flag says about them.
struct PacketMode {
    int width;
    bool is_coherent;
};
constexpr PacketMode kPacketModes[] = {
    {16, true}, {16, false}, {8, true}, {8, false}, {1, false}};

// Packed float and index triples, which the peer reads where they are: they outlive it. Behind the
// last vertex there is one that Embree may read.
struct EmbreeMesh {
    const void* positions;
    size_t vertex_count;
    const void* triangles;
    size_t triangle_count;
};

// In screen order.
struct EmbreeRays {
    const std::vector<rsh_ray>& rays;
    Size size;
};

class EmbreePeer {
public:
    EmbreePeer(const EmbreeMesh& mesh, EmbreeBuild build, bool is_robust, unsigned threads);

    void build();  // after the vertices moved

    // Active rays only; answers of others stay as they are. Hits carry t, u, v and primitive as
    // rsh's do, with Embree's u and v.
    void trace(const EmbreeRays& rays, PacketMode mode, std::vector<rsh_hit>& hits);
    void occlude(const EmbreeRays& rays, PacketMode mode, std::vector<cl_uint>& masks);

    rsh_hit trace_one(const rsh_ray& ray) const;

private:
    struct ReleaseDevice {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    };
    struct ReleaseScene {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };

    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device_;
    std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
    RTCGeometry geometry_ = nullptr;  // owned by the scene
    tbb::task_arena arena_;
};

}  // namespace bench
