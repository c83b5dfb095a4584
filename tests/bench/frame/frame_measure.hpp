// frame_measure.hpp - one row of the table: makes rays, checks every column's answers, then
// times all columns and all of their peers in turn, each round with moved vertices and new
// rays.
#pragma once

#include "frame/frame_rows.hpp"
#include "suite.hpp"

namespace bench {

struct RowSettings {
    double seconds;     // of timed rounds, about
    size_t min_rounds;  // whatever they take, unless the limit passes
};

// What the rows of a run have in common.
struct FrameRun {
    const Run& run;
    RowSettings settings;
    Estimate estimate;  // by column; the work is pixels and triangles
};

// One case per column, or a word why it is left out.
void measure_row(FrameRun& run, SceneOnDevice& scene, const FrameRow& row,
                 const std::vector<Column>& columns);

}  // namespace bench
