// build_rows.hpp - the hierarchy over a million rays against a copy of the rays' bytes on the
// device, in pairs: how far the build is from the speed of reading.
#pragma once

#include "frame/frame_rows.hpp"
#include "suite.hpp"

namespace bench {

struct BuildRow {
    SceneSpec scene;
    Size size;
    RayKind rays;

    std::string name() const;
};

std::vector<BuildRow> build_rows();

// The hierarchy over the rays does not depend on what became of the scene's order.
inline bool is_measured(const BuildRow&, const Column& column) {
    return !column.is_refit;
}

std::string case_name(const BuildRow& row, const Column& column);

// `pairs` is the number of timed pairs. metrics.build_over_copy: lower is better.
Case measure_build(const Device& device, SceneOnDevice& scene, const BuildRow& row,
                   const Column& column, size_t pairs);

}  // namespace bench
