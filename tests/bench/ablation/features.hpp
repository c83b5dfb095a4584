// features.hpp - what can be left out, and a work for each state of it: a row per feature. Runs nothing.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ablation/work.hpp"
#include "stability/family.hpp"

namespace bench::ablation {

// What the works of all features have in common.
struct Stage {
    const Device& device;
    cl_uint width, height;    // of frames
    stability::Scene layers;  // what rsh_trace is given: each ray crosses four surfaces
    size_t most_hits;         // of all its rays
};

// The scene does not have the feature, nor do the programs; the programs do; the general program, which asks
// the scene, finds that it does not; the scene does.
constexpr const char* kLeftOut = "left_out";
constexpr const char* kCompiledIn = "compiled_in";
constexpr const char* kGeneral = "general";
constexpr const char* kUsed = "used";

struct State {
    const char* name;                                         // one of these
    std::function<std::unique_ptr<Work>(const Stage&)> make;  // none: there is no such state
    std::string why_not;                                      // there is none
    bool is_counted = false;                                  // rsh_count_statistics is on
    bool is_general = false;  // by a context with RSH_NO_VARIANTS
};

struct Feature {
    std::string name;
    std::vector<State> states;  // in that order, the general one where there is one
    bool is_frame;              // else rays
};

std::vector<Feature> frame_features();
std::vector<Feature> ray_features();

}  // namespace bench::ablation
