#include "accuracy/references.hpp"

#include <algorithm>

#include "oracle/frame/reference_frame.hpp"

namespace bench::accuracy {
namespace {

using oracle::ReferencePixel;

constexpr uint32_t kSide = 8;
// Longer than the paths of rsh; what is lighter changes no pixel that anybody could see.
constexpr uint32_t kLongest = 64;
constexpr double kLightest = 1.0 / (1 << 18);
constexpr oracle::PathLimits kOne = {kLongest, kLightest, 1};
constexpr oracle::PathLimits kMany = {kLongest, kLightest, kSide};

Image image_of(const std::vector<ReferencePixel>& pixels, const oracle::View& view) {
    Image image = {view.width, view.height, {}};
    for (const ReferencePixel& pixel : pixels) image.pixels.push_back(pixel.colour);
    return image;
}

std::vector<Seen> seen_by(const test::Scene& scene, const oracle::View& view,
                          const std::vector<oracle::Hit>& hits) {
    std::vector<Seen> seen(hits.size());
    for (size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].primitive == RSH_NO_HIT) continue;
        const oracle::Ray ray =
            camera_ray(view, double(i % view.width) + 0.5, double(i / view.width) + 0.5);
        const oracle::Surface surface = surface_at(scene, ray, hits[i]);
        const uint32_t material =
            scene.material_ids.empty() ? 0 : scene.material_ids[hits[i].primitive];
        seen[i] = {material, surface.point, surface.geometric, hits[i].t};
    }
    return seen;
}

}  // namespace

References make_references(const Staged& staged, uint32_t width, uint32_t height) {
    const oracle::View view = {staged.camera, width, height};
    const oracle::SceneBvh bvh(staged.scene.mesh);
    const oracle::ReferenceFrame frame(staged.scene, bvh);
    const std::vector<ReferencePixel> truth = frame.render(view, kMany);
    const auto cut = std::count_if(truth.begin(), truth.end(), [](const ReferencePixel& pixel) {
        return pixel.cut_weight > 1.0 / 1024;
    });
    return {image_of(truth, view), image_of(frame.render(view, kOne), view),
            find_edges(seen_by(staged.scene, view, frame.first_hits(view)), width),
            double(cut) / double(truth.size())};
}

}  // namespace bench::accuracy
