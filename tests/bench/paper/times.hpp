// times.hpp - what the frames of a case took, as metrics.
#pragma once

#include <vector>

#include "paper/frame.hpp"
#include "paper/rows.hpp"

namespace bench::paper {

// Frame by frame; there is one at least.
struct Times {
    std::vector<double> frame_ms;  // by the host's clock, with what is sent
    std::vector<double> ms;        // FrameWork::ms
    std::vector<FrameWork> works;
};

// README.md lists the metrics.
nlohmann::json times_of(const Row& row, const Times& times);

}  // namespace bench::paper
