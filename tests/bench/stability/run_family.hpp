// run_family.hpp - one family: makes its scenes round by round, asks the oracle once per scene,
// and compares every engine's answers with it and with those of brute force.
#pragma once

#include "limit.hpp"
#include "results.hpp"
#include "stability/tally.hpp"
#include "stability/traced_scene.hpp"

namespace bench::stability {

struct Amount {
    Extent extent;
    uint32_t rounds;     // scenes, each from random numbers of its own
    size_t judged_rays;  // by the oracle, per round
};

// One case of a family: an engine with its bound, a layout of rays, a query.
struct Variant {
    Column column;
    bool is_list;
    bool is_any;
};

std::string case_name(const Family& family, const Variant& variant);
nlohmann::json params_of(const Family& family, const Variant& variant);

// Cases as they go into the JSON. `salt`: the same for a family in every run.
std::vector<Case> run_family(const Device& device, const Family& family, uint64_t salt,
                             const std::vector<Variant>& variants, const Amount& amount,
                             const Limit& limit);

}  // namespace bench::stability
