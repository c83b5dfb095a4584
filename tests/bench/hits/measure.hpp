// measure.hpp - one scene: every contender's answers are judged, then all are timed in turn on the same
// rays and triangles.
#pragma once

#include "hits/contender.hpp"
#include "hits/scenes.hpp"
#include "suite.hpp"

namespace bench::hits {

struct Amount {
    stability::Extent extent;
    double decisions;   // of the oracle, per scene: pairs of a ray and a triangle
    double pairs;       // that is_stream contenders may meet in a scene that is not coherent
    double seconds;     // of timed rounds, about
    size_t min_rounds;  // whatever they take, unless the limit passes
};

std::string case_name(const SceneKind& scene, const Amount& amount,
                      const ContenderKind& contender);

// One case per contender, or a word why it is left out.
void measure_scene(const Run& run, const SceneKind& kind,
                   const std::vector<ContenderKind>& contenders, const Amount& amount);

}  // namespace bench::hits
