// measure.hpp - one scene at one size: approximate frames are compared with the exact one, then all of
// them are timed in turn.
#pragma once

#include <string>
#include <vector>

#include "accuracy/scene_on_device.hpp"
#include "suite.hpp"

namespace bench::approximate {

struct Amount {
    std::vector<cl_uint> widths;  // of pictures, which are 4 : 3
    double seconds;               // of timed rounds per size, about
    size_t rounds;                // at most
};

struct Picture {
    std::string scene;
    cl_uint width;
    std::vector<float> tolerances;  // a case each

    cl_uint height() const { return width / 4 * 3; }
    std::string case_name(float tolerance) const;
};

// With the bounces and the cut-off by weight that the scene asks for.
void measure_picture(const Run& run, const Picture& picture, const accuracy::Staged& staged,
                     const accuracy::SceneOnDevice& scene, const Amount& amount);

}  // namespace bench::approximate
