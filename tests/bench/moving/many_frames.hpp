// many_frames.hpp - frames of a scene that moves as a whole, one after the other: time, and what the
// program's memory grows by.
#pragma once

#include "frame/ray_maker.hpp"
#include "results.hpp"

namespace bench::moving {

struct ManyFrames {
    int64_t triangles;
    Size size;
    size_t frames;

    std::string case_name() const;
    nlohmann::json params() const;
};

// Metrics:
//   ms, ms_low, ms_high   of a frame but the first two, with the upload of its vertices: median,
//                         quartiles
//   first_ms              of the first frame, which compiles
//   grown_kib             of resident memory, from the frame after a tenth of them to the last
//   is_within             whether that is at most 10 MB
Case measure(const Device& device, const ManyFrames& asked);
std::string as_text(const ManyFrames& asked, const Case& c);

}  // namespace bench::moving
