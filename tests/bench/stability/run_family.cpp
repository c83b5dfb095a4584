#include "stability/run_family.hpp"

#include <fmt/format.h>

namespace bench::stability {
namespace {

// A reference is traced in screen order.
std::vector<rsh_hit> brute_force(const TracedScene& scene) {
    Column column;
    column.engine = RSH_ENGINE_BRUTE_FORCE;
    return scene.closest(column, false);
}

void run_round(const Device& device, const Family& family, test::Random& random,
               const std::vector<Variant>& variants, const Amount& amount,
               std::vector<Tally>& tallies) {
    const Scene scene = family.make(random, amount.extent);
    const Expected expected = expected_answers(scene, family.kind, amount.judged_rays);
    const TracedScene on_device(device, scene);
    const std::vector<rsh_hit> reference = brute_force(on_device);
    for (size_t i = 0; i < variants.size(); ++i) {
        const auto& [column, is_list, is_any] = variants[i];
        if (is_any)
            tallies[i].add_occlusion(scene, expected, reference,
                                     on_device.any(column, is_list));
        else
            tallies[i].add_hits(scene, expected, reference, on_device.closest(column, is_list));
    }
}

}  // namespace

nlohmann::json params_of(const Family& family, const Variant& variant) {
    return {{"family", family.name},
            {"engine", variant.column.engine_name},
            {"bound", variant.column.bound_name},
            {"rays", variant.is_list ? "list" : "grid"},
            {"query", variant.is_any ? "any" : "closest"}};
}

std::string case_name(const Family& family, const Variant& variant) {
    const nlohmann::json p = params_of(family, variant);
    return fmt::format("stability/family:{}/engine:{}/bound:{}/rays:{}/query:{}", family.name,
                       variant.column.engine_name, variant.column.bound_name,
                       p["rays"].get<std::string>(), p["query"].get<std::string>());
}

std::vector<Case> run_family(const Device& device, const Family& family, uint64_t salt,
                             const std::vector<Variant>& variants, const Amount& amount,
                             const Limit& limit) {
    std::vector<Tally> tallies(variants.size());
    uint32_t rounds = 0;
    for (; rounds < amount.rounds && (rounds == 0 || !limit.has_passed()); ++rounds) {
        test::Random random(salt << 32 | rounds);
        run_round(device, family, random, variants, amount, tallies);
    }
    std::vector<Case> cases;
    for (size_t i = 0; i < variants.size(); ++i) {
        nlohmann::json p = params_of(family, variants[i]);
        p["rounds"] = rounds;
        cases.push_back({case_name(family, variants[i]), p, tallies[i].metrics(),
                         tallies[i].is_good(family.kind)});
    }
    return cases;
}

}  // namespace bench::stability
