// check.hpp - traces all waves of a frame a second time by brute force, through the public
// calls, and counts hits that differ in any bit. Renders no picture.
#pragma once

#include <string>

#include "device/device.hpp"

namespace render {

struct CheckResult {
    uint64_t hits = 0;  // compared: of camera, secondary and shadow rays
    uint64_t differ = 0;
    std::string first;  // the first difference; empty when there is none
};

// Checks every `ray_step`-th active ray of each wave; 1: all.
CheckResult check_frame(const Device& device, const rsh_frame_desc& frame, uint32_t ray_step);

}  // namespace render
