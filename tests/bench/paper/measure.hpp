// measure.hpp - one row with each engine: checked by brute force, then timed.
#pragma once

#include <string>
#include <vector>

#include "paper/rows.hpp"
#include "paper/scenes/scenes.hpp"
#include "suite.hpp"

namespace bench::paper {

struct Amount {
    double seconds;  // of timed frames per case, about, where nothing moves
    size_t
        frames;  // at most; of what moves: evenly over the animation, with the engine `tiles`
    size_t slow_frames;  // likewise with the others, which take seconds
    double audit_tests;  // of rays against triangles, by brute force, per wave
};

// A case per engine.
void measure_row(const Run& run, Estimate& estimate, const Row& row, MovingScene& scene,
                 const std::vector<std::string>& engines, const Amount& amount);

}  // namespace bench::paper
