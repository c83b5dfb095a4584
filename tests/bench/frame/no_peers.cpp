// no_peers.cpp - in place of embree/, without RSH_BENCH_PEERS.
#include "frame/frame_peer.hpp"

namespace bench {

std::vector<std::unique_ptr<FramePeer>> make_frame_peers(const Device&, const SceneOnDevice&,
                                                         const RayMaker&, bool) {
    return {};
}

std::string frame_peer_text(const nlohmann::json&) {
    return {};
}

}  // namespace bench
