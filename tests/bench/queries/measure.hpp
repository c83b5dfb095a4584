// measure.hpp - closest, any, count and all of the same rays, in turn.
#pragma once

#include "frame/rsh_tracer.hpp"
#include "results.hpp"
#include "stability/family.hpp"

namespace bench::queries {

struct Amount {
    uint32_t triangles, side;
    size_t rounds;
};

// `name`: of the scene. Answers are compared with those of brute force for some rays before anything
// is timed.
Case measure(const Device& device, const std::string& name, const stability::Scene& scene,
             const Column& column, const Amount& amount);
std::string case_name(const std::string& scene, const Column& column);
std::string as_text(const Case& c);

}  // namespace bench::queries
