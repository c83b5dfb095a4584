// embree_peer.hpp - Embree 3 on the same triangles and rays: rebuilt or refitted per frame,
// then traced in packets of neighbouring rays, in parallel, with as many threads as the OpenCL
// device has compute units. Written as its users would write it for geometry that moves every
// frame: vertex and index buffers shared, scene flag dynamic, not robust (the default),
// denormals flushed.
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

class EmbreePeer {
public:
    // `scene` must outlive the peer; its host vertices are what Embree reads.
    EmbreePeer(const SceneOnDevice& scene, EmbreeBuild build, unsigned threads);

    void build();  // after the vertices moved

    // Active rays only; answers of others stay as they are. Hits carry t, u, v and primitive as
    // rsh's do, with Embree's u and v.
    void trace(const RayMaker& rays, PacketMode mode, std::vector<rsh_hit>& hits);
    void occlude(const RayMaker& rays, PacketMode mode, std::vector<cl_uint>& masks);

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
