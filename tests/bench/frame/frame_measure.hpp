// frame_measure.hpp - one row of the table: makes rays, checks every column's answers, then
// times all columns and all of their peers in turn, each round with moved vertices and new
// rays.
#pragma once

#include <map>

#include "frame/frame_rows.hpp"
#include "suite.hpp"

namespace bench {

struct RowSettings {
    double seconds;     // of timed rounds, about
    size_t min_rounds;  // whatever they take, unless the limit passes
};

// Devices by the width that their kernels are compiled for.
using DevicesByWidth = std::map<cl_uint, Device>;

// What the rows of a run have in common.
struct FrameRun {
    const Run& run;
    const DevicesByWidth& devices;
    RowSettings settings;
    Estimate estimate;  // by column; the work is pixels and triangles
};

// One case per column, or a word why it is left out.
void measure_row(FrameRun& run, SceneOnDevice& scene, const FrameRow& row,
                 const std::vector<Column>& columns);

}  // namespace bench
