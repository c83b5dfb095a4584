// frame_peer.hpp - another library that traces the rays of a row in turn with rsh: what it is asked
// and what it puts into a case. The folder embree/ has the one there is; no_peers.cpp takes its
// place without RSH_BENCH_PEERS.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "frame/ray_maker.hpp"

namespace bench {

class FramePeer {
public:
    virtual ~FramePeer() = default;

    // Of the present moment: the answers that those of rsh are compared with, then how these
    // differ, by cause.
    virtual void answer() = 0;
    virtual void compare(const std::vector<rsh_hit>& ours, nlohmann::json& metrics) const = 0;
    virtual void compare_occlusion(const std::vector<cl_uint>& ours,
                                   nlohmann::json& metrics) const = 0;

    virtual void time_round() = 0;
    // `ours_ms`: rsh's totals of the first rounds, one or more.
    virtual void put_times(const std::vector<double>& ours_ms,
                           nlohmann::json& metrics) const = 0;
};

// All there are. `scene` and `rays` outlive them and change between rounds; there is an active ray.
std::vector<std::unique_ptr<FramePeer>> make_frame_peers(const Device& device,
                                                         const SceneOnDevice& scene,
                                                         const RayMaker& rays, bool is_shadow);

// Of a case with the metrics of a peer: "; Embree ..." for the line of text; else empty.
std::string frame_peer_text(const nlohmann::json& metrics);

}  // namespace bench
