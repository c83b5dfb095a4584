#include "stability/sum.hpp"

#include <algorithm>

#include "frame/checksum.hpp"

namespace bench::stability {
namespace {

using nlohmann::json;

uint64_t sum(const std::vector<Case>& cases, const char* key) {
    uint64_t all = 0;
    for (const Case& c : cases) all += c.metrics.value(key, uint64_t{0});
    return all;
}

}  // namespace

Case sum_of(const std::vector<Case>& cases, const Totals& totals) {
    json metrics = {{"rays", totals.rays},
                    {"pairs", totals.pairs},
                    {"decisions", totals.decisions},
                    {"undecided", totals.undecided}};
    for (const char* key :
         {"missed", "spurious", "wrong_triangle", "differ", "nan_out", "self_hits"})
        metrics[key] = sum(cases, key);
    double t_error = 0;
    std::string hashes;
    for (const Case& c : cases) {
        t_error = std::max(t_error, c.metrics.value("t_error_of_budget", 0.0));
        hashes += c.metrics.value("hash", std::string());
    }
    metrics["t_error_of_budget"] = t_error;
    metrics["hash"] = checksum(std::vector<char>(hashes.begin(), hashes.end()));
    const json params = {{"family", "all"},
                         {"engine", "all"},
                         {"bound", "all"},
                         {"rays", "all"},
                         {"query", "all"}};
    return {"stability/all", params, metrics,
            std::all_of(cases.begin(), cases.end(), [](const Case& c) { return c.ok; })};
}

}  // namespace bench::stability
