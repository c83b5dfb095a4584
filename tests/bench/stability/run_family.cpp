#include "stability/run_family.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "stability/spawned/spawn.hpp"

namespace bench::stability {
namespace {

// Traced in screen order.
Reference brute_force(const TracedScene& scene, size_t rays) {
    Column column;
    column.engine = RSH_ENGINE_BRUTE_FORCE;
    return {scene.closest(column, false), scene.all(column, false, rays)};
}

void add_answers(const Scene& scene, const Expected& expected, const Reference& reference,
                 const TracedScene& on_device, const Variant& variant, Tally& tally) {
    const auto& [column, is_list, query] = variant;
    if (query == RSH_QUERY_CLOSEST)
        tally.add_hits(scene, expected, reference.closest, on_device.closest(column, is_list));
    else if (query == RSH_QUERY_ANY)
        tally.add_occlusion(scene, expected, reference.closest, on_device.any(column, is_list));
    else if (query == RSH_QUERY_COUNT)
        tally.add_counts(scene, expected, reference.all, on_device.counts(column, is_list));
    else
        tally.add_all(scene, expected, reference.all,
                      on_device.all(column, is_list, reference.all.hits.size()));
}

const char* name_of_query(cl_uint query) {
    constexpr const char* kNames[] = {"closest", "any", "count", "all"};
    return kNames[query];
}

// Adds to the tallies of those variants whose turn it is.
Totals run_round(const Device& device, const Family& family, test::Random& random,
                 const std::vector<Variant>& variants, const Amount& amount, uint32_t round,
                 std::vector<Tally>& tallies) {
    Scene scene = family.make(random, amount.extent(round));
    SpawnFaults faults;
    if (scene.spawning) {
        const Spawned spawned = spawn(device, scene);
        faults = spawn_faults(scene, spawned, amount.judged_rays);
    }
    const Expected expected = expected_answers(
        scene, family.kind, amount.judged_rays,
        device.keeps_denormals() ? oracle::Denormals::kKept : oracle::Denormals::kMayBeFlushed);
    const TracedScene on_device(device, scene);
    const Reference reference = brute_force(on_device, scene.rays.rays.size());
    const uint64_t pairs = count_pairs(scene);
    Totals totals = {scene.rays.rays.size(), pairs, expected.decisions, expected.undecided};
    for (size_t i = 0; i < variants.size(); ++i) {
        if (!amount.goes(round, variants[i].way())) continue;
        totals.pairs += pairs;
        tallies[i].add_spawned(faults);
        add_answers(scene, expected, reference, on_device, variants[i], tallies[i]);
    }
    return totals;
}

bool any_goes(const std::vector<Variant>& variants, const Amount& amount, uint32_t round) {
    return std::any_of(variants.begin(), variants.end(),
                       [&](const Variant& v) { return amount.goes(round, v.way()); });
}

}  // namespace

nlohmann::json params_of(const Family& family, const Variant& variant) {
    return {{"family", family.name},
            {"engine", variant.column.engine_name},
            {"bound", variant.column.bound_name},
            {"rays", variant.is_list ? "list" : "grid"},
            {"query", name_of_query(variant.query)}};
}

std::string case_name(const Family& family, const Variant& variant) {
    const nlohmann::json p = params_of(family, variant);
    return fmt::format("stability/family:{}/engine:{}/bound:{}/rays:{}/query:{}", family.name,
                       variant.column.engine_name, variant.column.bound_name,
                       p["rays"].get<std::string>(), p["query"].get<std::string>());
}

FamilyResult run_family(const Device& device, const Family& family, uint64_t salt,
                        const std::vector<Variant>& variants, const Amount& amount,
                        const Limit& limit, const std::function<void(uint32_t)>& begin) {
    std::vector<Tally> tallies(variants.size());
    FamilyResult result;
    for (; result.rounds < amount.rounds; ++result.rounds) {
        const bool is_turn_done = result.rounds >= (amount.is_in_turn ? kWays : 1);
        if (is_turn_done && limit.has_passed()) break;
        begin(result.rounds);
        if (!any_goes(variants, amount, result.rounds)) continue;
        test::Random random(salt << 32 | result.rounds);
        result.totals.add(
            run_round(device, family, random, variants, amount, result.rounds, tallies));
    }
    for (size_t i = 0; i < variants.size(); ++i) {
        nlohmann::json p = params_of(family, variants[i]);
        p["rounds"] = result.rounds;
        result.cases.push_back({case_name(family, variants[i]), p, tallies[i].metrics(),
                                tallies[i].is_good(family.kind)});
    }
    return result;
}

}  // namespace bench::stability
