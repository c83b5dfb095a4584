// embree_contenders.cpp - Embree 3 in its default mode and in its robust one, each with the build and
// the packets that are quickest for the rays.
#include <algorithm>
#include <limits>
#include <numeric>

#include "frame/embree/embree_peer.hpp"
#include "hits/contender.hpp"
#include "timing.hpp"

namespace bench::hits {
namespace {

class EmbreeContender final : public Contender {
public:
    EmbreeContender(const DeviceScene& scene, bool is_robust)
        : scene_(scene.host()),
          size_(scene.size()),
          positions_(scene_.mesh.vertices),
          indices_(scene_.mesh.indices),
          hits_(size_.pixels()) {
        positions_.emplace_back();  // Embree may read it
        if (indices_.empty()) {
            indices_.resize(scene_.mesh.vertices.size());
            std::iota(indices_.begin(), indices_.end(), 0u);
        }
        const auto threads = scene.device().device().getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
        choose(is_robust, threads);
    }

    double trace() override {
        return milliseconds([&] { peer_->build(); }) + trace(*peer_, mode_);
    }
    std::vector<rsh_hit> hits() const override { return hits_; }
    void describe(nlohmann::json& metrics) const override {
        metrics["build"] = name_of(build_);
        metrics["packet"] = mode_.width;
        metrics["coherent"] = mode_.is_coherent;
    }

private:
    double trace(EmbreePeer& peer, PacketMode mode) {
        for (size_t i = 0; i < hits_.size(); ++i)
            hits_[i] = {scene_.rays.rays[i].direction_tmax.s[3], 0, 0, RSH_NO_HIT};
        return milliseconds([&] { peer.trace({scene_.rays.rays, size_}, mode, hits_); });
    }

    // The first run warms caches up, unless it takes long.
    double try_out(EmbreePeer& peer, PacketMode mode) {
        constexpr double kLongMs = 200;
        const double ms = trace(peer, mode);
        return ms > kLongMs ? ms : std::min(ms, trace(peer, mode));
    }

    void choose(bool is_robust, unsigned threads) {
        double best = std::numeric_limits<double>::infinity();
        for (const EmbreeBuild build : {EmbreeBuild::kLow, EmbreeBuild::kMedium}) {
            auto peer = std::make_unique<EmbreePeer>(
                EmbreeMesh{positions_.data(), positions_.size() - 1, indices_.data(),
                           indices_.size() / 3},
                build, is_robust, threads);
            peer->build();
            const double build_ms = milliseconds([&] { peer->build(); });
            double trace_ms = std::numeric_limits<double>::infinity();
            PacketMode quickest{};
            for (const PacketMode mode : kPacketModes) {
                const double ms = try_out(*peer, mode);
                if (ms >= trace_ms) continue;
                trace_ms = ms;
                quickest = mode;
            }
            if (build_ms + trace_ms >= best) continue;
            best = build_ms + trace_ms;
            build_ = build;
            mode_ = quickest;
            peer_ = std::move(peer);
        }
    }

    const stability::Scene& scene_;
    Size size_;
    std::vector<test::Float3> positions_;
    std::vector<uint32_t> indices_;
    std::vector<rsh_hit> hits_;
    std::unique_ptr<EmbreePeer> peer_;
    EmbreeBuild build_ = EmbreeBuild::kLow;
    PacketMode mode_{};
};

}  // namespace

std::vector<ContenderKind> peer_contenders() {
    std::vector<ContenderKind> kinds;
    for (const bool is_robust : {false, true}) {
        const std::string mode = is_robust ? "robust" : "default";
        kinds.push_back({"engine:embree/mode:" + mode, "embree/" + mode, /*is_peer=*/true,
                         /*is_stream=*/false, /*is_yardstick=*/false,
                         [is_robust](const DeviceScene& scene) {
                             return std::make_unique<EmbreeContender>(scene, is_robust);
                         }});
    }
    return kinds;
}

}  // namespace bench::hits
