// reference_frame.hpp - a whole frame in double precision, from the definitions in rsh_types.h and
// rsh.h: what rsh_frame would show if nothing were rounded. Slow; shares no code with the kernels.
//
// A secondary ray does not hit the triangle that it leaves, nor what is nearer than 2^-36 of the largest
// coordinate: thousands of times what doubles err by, and thousands of times less than floats tell
// apart. In the limit it leaves from the surface, as rsh.h says of rsh_spawn.
#pragma once

#include <vector>

#include "oracle/frame/scene_bvh.hpp"
#include "oracle/whitted.hpp"

namespace oracle {

struct View {
    rsh_camera camera;
    uint32_t width, height;
};

// Through a point of the picture, in pixels from its left and top: (0.5, 0.5) is the first centre.
Ray camera_ray(const View& view, double x, double y);

struct PathLimits {
    uint32_t bounces;
    double min_weight = 0;  // secondary rays that weigh no more are cut, see rsh_scene's cut
    uint32_t side = 1;      // of a pixel's square of samples, evenly spread; their mean counts
};

struct ReferencePixel {
    test::Double3 colour;
    double cut_weight = 0;  // all rays together that were cut: what they see has this weight
};

class ReferenceFrame {
public:
    // Both must stay.
    ReferenceFrame(const test::Scene& scene, const SceneBvh& bvh) : scene_(scene), bvh_(bvh) {}

    // Row by row from the top, on all cores.
    std::vector<ReferencePixel> render(const View& view, const PathLimits& limits) const;
    std::vector<Hit> first_hits(const View& view) const;  // at the centres of the pixels

private:
    struct Path;
    test::Double3 seen_by(const Ray& ray, Path path) const;
    test::Double3 seen_by(const Secondary& secondary, const Surface& from, uint32_t triangle,
                          Path path) const;
    test::Double3 cut(test::Double3 direction) const;
    uint32_t hidden_lights(const Surface& surface, uint32_t triangle) const;

    const test::Scene& scene_;
    const SceneBvh& bvh_;
};

}  // namespace oracle
