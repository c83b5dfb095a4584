// strips.hpp - into how many strips a picture is cut, so that a frame and what rsh-render itself
// holds of the picture keep to one budget. Renders nothing.
#pragma once

#include "device/device.hpp"

namespace render {

struct StripPlan {
    uint32_t rows = 0;        // of all strips but the last: a multiple of 64, or the picture's
    size_t frame_budget = 0;  // of rsh_frame, per strip
};

// `picture` is rsh_frame's description of all of it. 0 bytes: a quarter of the device's memory, at
// most its largest allocation and 1.5 GiB. The strips' colours, on the device and on the host, take
// at most an eighth where they can, rsh_frame the rest. Throws std::runtime_error, which names the
// least, where `budget` is too small for 64 rows.
StripPlan plan_strips(const rsh::Device& device, const rsh_frame_desc& picture, size_t budget);

}  // namespace render
