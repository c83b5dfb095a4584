// judge.hpp - what is wrong with a float routine's answer, by the oracle's. Knows no test
// framework: accepts.hpp makes assertions of it.
#pragma once

#include <string>

#include "oracle/closest.hpp"

namespace oracle {

enum class Fault {
    kNone,
    kMissed,        // a certain hit was not found, or something behind it was
    kSpurious,      // no correct routine reports this hit, its t, or its u and v
    kWrongTriangle  // only another one is right
};

struct Verdict {
    Fault fault = Fault::kNone;
    std::string why = {};  // "cannot hit that triangle"; empty: nothing is wrong
    // |t - exact| over what the derived bound allows; 0 without a hit that is possible.
    double t_error_of_budget = 0;
};

Verdict judge_hit(const Answer& answer, const test::Mesh& mesh, const rsh_ray& ray,
                  const rsh_hit& hit, Denormals denormals = Denormals::kMayBeFlushed);

// is_hit: what the routine says of any hit at all.
Verdict judge_occlusion(const Answer& answer, bool is_hit);

}  // namespace oracle
