// frame_measure.hpp - one row of the table: makes rays, checks every column's answers, then
// times all columns and all of Embree's ways in turn, each round with moved vertices and new
// rays.
#pragma once

#include "frame/frame_rows.hpp"
#include "suite.hpp"

namespace bench {

struct RowSettings {
    double seconds;     // of timed rounds, about
    size_t min_rounds;  // whatever they take
};

// One Case per column. A row without any active ray gives none.
std::vector<Case> measure_row(const Device& device, SceneOnDevice& scene, const FrameRow& row,
                              const std::vector<Column>& columns, const RowSettings& settings);

}  // namespace bench
