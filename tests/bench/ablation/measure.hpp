// measure.hpp - the states of one feature: checked, counted, compiled, then timed in turn.
#pragma once

#include <map>
#include <string>

#include "ablation/features.hpp"
#include "suite.hpp"

namespace bench::ablation {

struct Amount {
    cl_uint width, height;         // of pictures
    uint32_t triangles, ray_side;  // of what is traced
    size_t rounds;
    bool finishes;  // programs are also finished in first runs, see Compiled
};

// Processor time, all threads together, that programs take in a context that knows none of them.
struct Compiled {
    double compile_ms = 0;  // of rsh_prepare
    double finish_ms =
        0;  // of the first run after that less a second one: of what drivers put off
    size_t programs = 0;
};
using CompiledBy = std::map<std::string, Compiled>;  // by Work::programs(), and whether general

std::string case_name(const Feature& feature, const State& state);

// A case per state, or a word why there is none. known: of features before; grows.
void measure(const Run& run, const Stage& stage, const Feature& feature, const Amount& amount,
             CompiledBy& known);

}  // namespace bench::ablation
