// report.hpp - what was measured, as a table for people and as JSON for programs. Measures
// nothing.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

#include "device/renderer.hpp"

namespace render {

struct RunReport {
    std::string device, platform;
    std::string engine, strategy;
    uint64_t triangles = 0;
    glm::uvec2 size{0};
    uint32_t bounces = 0;
    double tolerance = 0;  // above: the frames are approximate
    double load_ms = 0.0;  // reading the scene
    double first_frame_ms =
        0.0;  // the unmeasured frame that compiles programs and grows scratch
    uint64_t programs_built = 0;  // by that frame
    uint64_t programs_loaded = 0;
    std::vector<FrameMeasure> frames;
};

// Milliseconds of one stage, in the paper's breakdown. The last stage, "other", is the total
// less the named ones, so that the stages add up to the total: clears, launch gaps, waits of
// the host.
struct StageTime {
    const char* name;
    const char* key;  // in JSON
    double ms;
};
std::vector<StageTime> stage_times(const FrameMeasure& frame);

// What is said of approximate frames; of exact ones, nothing.
std::string approximation(double tolerance);

// Means over all frames.
std::string table(const RunReport& report);

nlohmann::json as_json(const RunReport& report);

std::string json_text(const nlohmann::json& json);

}  // namespace render
