// contender.hpp - who traces the rays of a scene: each engine of rsh with its bound, and peers.
#pragma once

#include <functional>
#include <memory>

#include "frame/rsh_tracer.hpp"
#include "stability/family.hpp"

namespace bench::hits {

// Triangles and rays on the host and in buffers.
class DeviceScene {
public:
    DeviceScene(const Device& device, const stability::Scene& scene);

    const Device& device() const { return device_; }
    const stability::Scene& host() const { return scene_; }
    const rsh_geometry& geometry() const { return geometry_; }
    const cl::Buffer& rays() const { return rays_; }
    Size size() const { return {scene_.rays.width, scene_.rays.height}; }

private:
    const Device& device_;
    const stability::Scene& scene_;
    cl::Buffer vertices_, indices_, rays_;
    rsh_geometry geometry_{};
};

class Contender {
public:
    virtual ~Contender() = default;
    // Makes what bounds the triangles anew, then finds all closest hits: milliseconds.
    virtual double trace() = 0;
    virtual std::vector<rsh_hit> hits() const = 0;  // of the last trace
    virtual void describe(nlohmann::json&) const {}
};

struct ContenderKind {
    std::string name;   // "engine:tiles/bound:box", "engine:embree/mode:robust"
    std::string label;  // "tiles/box", "embree/robust"
    bool is_peer;       // whose errors are reported, and no fault of rsh's
    bool is_stream;     // goes by pairs of a ray and a triangle, with no early exit
    bool is_yardstick;  // by all of them, in any scene
    std::function<std::unique_ptr<Contender>(const DeviceScene&)> make;  // BLOCKS
};

// Brute force first, then the others.
std::vector<ContenderKind> rsh_contenders(const Device& device);

// The folder embree/ has those there are; no_peers.cpp takes its place without RSH_BENCH_PEERS.
std::vector<ContenderKind> peer_contenders();

}  // namespace bench::hits
