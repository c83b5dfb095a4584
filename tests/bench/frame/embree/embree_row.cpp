// embree_row.cpp - Embree as a frame's peer: built in three ways, each with the packet that is
// quickest for the rays, all timed in every round.
#include <fmt/format.h>

#include <algorithm>

#include "frame/embree/embree_check.hpp"
#include "frame/frame_peer.hpp"
#include "timing.hpp"

namespace bench {
namespace {

// Built in one way, with its times of each round.
struct Embree {
    EmbreeBuild build;
    std::unique_ptr<EmbreePeer> peer;
    PacketMode mode{16, true};
    std::vector<double> build_ms, trace_ms, total_ms;
};

Spread ratio(const std::vector<double>& base, const std::vector<double>& work) {
    std::vector<double> ratios;
    for (size_t i = 0; i < work.size(); ++i) ratios.push_back(base[i] / work[i]);
    return spread(ratios);
}

EmbreeMesh mesh_of(const SceneOnDevice& scene) {
    const render::Mesh& mesh = scene.frame_scene().mesh();
    return {scene.positions().data(), mesh.positions.size(), mesh.triangles.data(),
            mesh.triangles.size()};
}

class EmbreeRow final : public FramePeer {
public:
    EmbreeRow(const Device& device, const SceneOnDevice& scene, const RayMaker& rays,
              bool is_shadow)
        : device_(device),
          scene_(scene),
          rays_(rays),
          is_shadow_(is_shadow),
          hits_(rays.size().pixels()),
          masks_(rays.size().pixels()) {
        const auto threads = device.device().getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
        for (const EmbreeBuild build :
             {EmbreeBuild::kLow, EmbreeBuild::kMedium, EmbreeBuild::kRefit})
            embrees_.push_back({build,
                                std::make_unique<EmbreePeer>(mesh_of(scene), build,
                                                             /*is_robust=*/false, threads),
                                {16, true},
                                {},
                                {},
                                {}});
        rays_.rays();  // read now, not in the timed part
        for (Embree& embree : embrees_) choose_mode(embree);
    }

    void answer() override { trace(embrees_.front(), embrees_.front().mode); }

    void compare(const std::vector<rsh_hit>& ours, nlohmann::json& metrics) const override {
        put(compare_hits(scene_, rays_, ours, hits_), metrics);
    }
    void compare_occlusion(const std::vector<cl_uint>& ours,
                           nlohmann::json& metrics) const override {
        put(bench::compare_occlusion(device_, scene_, rays_, ours, *embrees_.front().peer,
                                     masks_),
            metrics);
    }

    void time_round() override {
        rays_.rays();
        for (Embree& embree : embrees_) {
            let_threads_sleep();
            embree.build_ms.push_back(milliseconds([&] { embree.peer->build(); }));
            embree.trace_ms.push_back(trace(embree, embree.mode));
            embree.total_ms.push_back(embree.build_ms.back() + embree.trace_ms.back());
        }
    }
    void put_times(const std::vector<double>& ours_ms, nlohmann::json& metrics) const override;

private:
    double trace(Embree& embree, PacketMode mode) {
        return milliseconds([&] {
            if (is_shadow_)
                embree.peer->occlude({rays_.rays(), rays_.size()}, mode, masks_);
            else
                embree.peer->trace({rays_.rays(), rays_.size()}, mode, hits_);
        });
    }

    // Embree gets what is quickest for these rays: packets or single rays, either flag.
    void choose_mode(Embree& embree) {
        double best = 1e30;
        for (const PacketMode mode : kPacketModes) {
            const double ms = std::min(trace(embree, mode), trace(embree, mode));
            if (ms >= best) continue;
            best = ms;
            embree.mode = mode;
        }
    }

    static void put(const DifferenceCounts& differences, nlohmann::json& metrics) {
        metrics.update({{"embree_same_distance", differences.same_distance},
                        {"embree_edge", differences.edge},
                        {"embree_grazing", differences.grazing},
                        {"embree_other", differences.other}});
    }

    const Embree& best_rebuild() const {
        const Embree &low = embrees_[0], &medium = embrees_[1];
        return spread(low.total_ms).median <= spread(medium.total_ms).median ? low : medium;
    }

    const Device& device_;
    const SceneOnDevice& scene_;
    const RayMaker& rays_;
    bool is_shadow_;
    std::vector<rsh_hit> hits_;
    std::vector<cl_uint> masks_;
    std::vector<Embree> embrees_;
};

void EmbreeRow::put_times(const std::vector<double>& ours_ms, nlohmann::json& metrics) const {
    const Embree &best = best_rebuild(), &refit = embrees_[2];
    const Spread against = ratio(best.total_ms, ours_ms);
    metrics.update({{"embree_build", name_of(best.build)},
                    {"embree_packet", best.mode.width},
                    {"embree_build_ms", spread(best.build_ms).median},
                    {"embree_trace_ms", spread(best.trace_ms).median},
                    {"embree_refit_ms", spread(refit.build_ms).median},
                    {"embree_refit_trace_ms", spread(refit.trace_ms).median},
                    {"ratio_embree", against.median},
                    {"ratio_embree_low", against.low},
                    {"ratio_embree_high", against.high},
                    {"ratio_embree_refit", ratio(refit.total_ms, ours_ms).median}});
}

}  // namespace

std::vector<std::unique_ptr<FramePeer>> make_frame_peers(const Device& device,
                                                         const SceneOnDevice& scene,
                                                         const RayMaker& rays, bool is_shadow) {
    std::vector<std::unique_ptr<FramePeer>> peers;
    peers.push_back(std::make_unique<EmbreeRow>(device, scene, rays, is_shadow));
    return peers;
}

std::string frame_peer_text(const nlohmann::json& m) {
    return fmt::format(
        "; Embree {} {:.2f} + {:.2f}, refit {:.2f} + {:.2f}; ratio {:.2f}, refit "
        "{:.2f}",
        m["embree_build"].get<std::string>(), m["embree_build_ms"].get<double>(),
        m["embree_trace_ms"].get<double>(), m["embree_refit_ms"].get<double>(),
        m["embree_refit_trace_ms"].get<double>(), m["ratio_embree"].get<double>(),
        m["ratio_embree_refit"].get<double>());
}

}  // namespace bench
