// run_family.hpp - one family: makes its scenes round by round, asks the oracle once per scene,
// and compares every engine's answers with it and with those of brute force.
#pragma once

#include <functional>

#include "limit.hpp"
#include "results.hpp"
#include "stability/amount.hpp"
#include "stability/tally.hpp"
#include "stability/totals.hpp"
#include "stability/traced_scene.hpp"

namespace bench::stability {

// One case of a family: an engine with its bound, a layout of rays, a query.
struct Variant {
    Column column;
    bool is_list;
    cl_uint query;

    uint32_t way() const { return 2u * is_list + query % 2; }
};

std::string case_name(const Family& family, const Variant& variant);
nlohmann::json params_of(const Family& family, const Variant& variant);

struct FamilyResult {
    std::vector<Case> cases;  // as they go into the JSON
    Totals totals;
    uint32_t rounds = 0;  // fewer than asked for when the limit passed
};

// `salt`: the same for a family in every run. `begin`: called before each round.
FamilyResult run_family(const Device& device, const Family& family, uint64_t salt,
                        const std::vector<Variant>& variants, const Amount& amount,
                        const Limit& limit, const std::function<void(uint32_t)>& begin);

}  // namespace bench::stability
