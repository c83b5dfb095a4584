// measure.hpp - one scene: all its frames are compared with the references, then timed in turn.
#pragma once

#include "accuracy/axes.hpp"
#include "accuracy/scenes.hpp"
#include "suite.hpp"

namespace bench::accuracy {

struct Amount {
    uint32_t width, height;  // of the default picture, 4 : 3, multiples of 4
    double decisions;      // of the oracle, per picture: pairs of a camera's ray and a triangle
    double pairs;          // the same, that brute force may meet
    double seconds;        // of timed rounds, about
    size_t rounds;         // at most
    std::string pictures;  // a folder to write them to; empty: they are not written
};

std::string case_name(const SceneKind& scene, const Point& point);

// One case per point, or a word why it is left out.
void measure_scene(const Run& run, const SceneKind& kind, const Staged& staged,
                   const std::vector<Point>& points, const Amount& amount);

}  // namespace bench::accuracy
