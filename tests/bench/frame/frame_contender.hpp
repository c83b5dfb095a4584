// frame_contender.hpp - rsh in one column of a row: checked, counted, timed, and what came of it.
#pragma once

#include <memory>

#include "frame/frame_peer.hpp"
#include "frame/rsh_tracer.hpp"

namespace bench {

using FramePeers = std::vector<std::unique_ptr<FramePeer>>;

constexpr double kCheckedMoment = 0.3, kEarlierMoment = 1.2;

struct FrameContender {
    Column column;
    std::unique_ptr<RshTracer> tracer;
    bool is_wrong = false;
    std::string why_left_out;  // right as far as is known, but never timed
    nlohmann::json metrics = nlohmann::json::object();
    std::string hits_checksum;  // of the checked moment, whatever the number of rounds
    std::vector<double> total_ms, bound_ms, build_ms, traverse_ms;

    // A wrong answer has no speed; seconds per frame tell all there is to tell after one round.
    bool is_done() const;

    // `scene` and `rays` are those of the checked moment, and again afterwards.
    void check(SceneOnDevice& scene, const RayMaker& rays, bool is_shadow,
               const FramePeers& peers);
    void count(const RayMaker& rays, size_t active_rays);
    void time(const RayMaker& rays);
    double put_times(const FramePeers& peers);  // returns the median of ms_total
};

}  // namespace bench
