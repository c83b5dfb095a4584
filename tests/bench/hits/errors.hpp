// errors.hpp - how many answers of a contender are wrong, and how, by the oracle. Knows no device.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "stability/expected.hpp"

namespace bench::hits {

struct Errors {
    uint64_t rays = 0;    // active ones
    uint64_t judged = 0;  // of these, those that the oracle was asked about
    uint64_t missed = 0, spurious = 0, wrong_triangle = 0;
    // The right triangle, with t, u or v farther off than the bound that is derived for floats.
    uint64_t inexact = 0;
    uint64_t leaks = 0;  // of all active rays, those out of a closed mesh
    std::string first;   // "ray 17 misses a certain hit"; empty: there is none

    uint64_t all() const { return missed + spurious + wrong_triangle + inexact + leaks; }
    void put(nlohmann::json& metrics) const;
};

// Where several answers are within rounding, all of them are right.
Errors count_errors(const stability::Scene& scene, const stability::Expected& expected,
                    bool is_closed, const std::vector<rsh_hit>& hits);

// Active rays whose answers are not the same bits.
uint64_t count_differing(const std::vector<rsh_ray>& rays, const std::vector<rsh_hit>& a,
                         const std::vector<rsh_hit>& b);

}  // namespace bench::hits
