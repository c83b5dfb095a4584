#include "mirrors/mirror_cases.hpp"

#include <fmt/format.h>

#include <cmath>

#include "oracle/quantile.hpp"

namespace bench::mirrors {
namespace {

using nlohmann::json;
using oracle::Errors;
using oracle::ErrorTable;
using oracle::Followed;
using oracle::Line;

// Four digits, as more mean nothing; null where it is infinite, as JSON has no infinity.
json as_json(double value) {
    if (!std::isfinite(value)) return nullptr;
    return std::stod(fmt::format("{:.4g}", value));
}

void add_quantiles(const ErrorTable& table, size_t bounce, const std::string& name,
                   double Errors::*error, json* metrics) {
    (*metrics)[name + "_p10"] = as_json(table.quantile(bounce, error, 0.1));
    (*metrics)[name + "_median"] = as_json(table.quantile(bounce, error, 0.5));
    (*metrics)[name + "_p90"] = as_json(table.quantile(bounce, error, 0.9));
}

void add_growth(const Followed& followed, size_t bounce, json* metrics) {
    std::vector<double> all;
    for (const auto& path : followed.growth) all.push_back(path[bounce - 1]);
    (*metrics)["growth_median"] = as_json(oracle::quantile(all, 0.5));
    (*metrics)["growth_p90"] = as_json(oracle::quantile(all, 0.9));
}

// Says so in the metrics if rsh errs too much.
bool is_near_the_best(const Followed& followed, size_t bounce, json* metrics) {
    const ErrorTable& best = followed.lines[oracle::kBestFloats];
    if (double(best.lost_by(bounce)) > kComparedShare * double(best.path_count())) return true;
    const double times = times_the_best(followed, bounce);
    (*metrics)["times_the_best"] = as_json(times);
    if (times <= kMostTimesTheBest) return true;
    (*metrics)["why"] =
        fmt::format("errs {:.3g} times as much as the best floats, must be {} at most", times,
                    kMostTimesTheBest);
    return false;
}

bool is_faultless(const oracle::Faults& faults, json* metrics) {
    (*metrics)["nan_out"] = faults.nan;
    (*metrics)["self_hits"] = faults.self_hits;
    (*metrics)["leaks"] = faults.leaks;
    if (faults.nan + faults.self_hits + faults.leaks == 0) return true;
    (*metrics)["why"] = fmt::format("{} paths with NaN, {} with self hits, {} leaks: must be 0",
                                    faults.nan, faults.self_hits, faults.leaks);
    return false;
}

// A case without its answers yet.
Case case_of(Line line, bool is_smooth, const json& bounce) {
    const char* normals = name_of_normals(is_smooth);
    const std::string last = bounce.is_number() ? "bounce:" + bounce.dump() : "summary";
    return {fmt::format("mirrors/normals:{}/line:{}/{}", normals, name_of(line), last),
            {{"normals", normals}, {"line", name_of(line)}, {"bounce", bounce}},
            json::object()};
}

Case case_at(const Followed& followed, Line line, size_t bounce, bool is_smooth) {
    const ErrorTable& table = followed.lines[line];
    Case made = case_of(line, is_smooth, bounce);
    made.metrics = {{"paths", table.path_count()}, {"lost", table.lost_by(bounce)}};
    add_quantiles(table, bounce, "position_error", &Errors::position, &made.metrics);
    add_quantiles(table, bounce, "direction_error", &Errors::direction, &made.metrics);
    add_quantiles(table, bounce, "next_hit_error", &Errors::next_hit, &made.metrics);
    if (line == oracle::kOneRounding) add_growth(followed, bounce, &made.metrics);
    if (line == oracle::kTracer) made.ok = is_near_the_best(followed, bounce, &made.metrics);
    return made;
}

json bounce_or_null(size_t bounce) {
    return bounce == 0 ? json() : json(bounce);
}

// The bounce by which half are lost; one more than there are, if fewer are.
double half_life(const ErrorTable& table) {
    const size_t bounce = table.bounce_when_lost(0.5);
    return double(bounce == 0 ? table.bounce_count() + 1 : bounce);
}

bool lasts_as_long_as_the_best(const Followed& followed, json* metrics) {
    const double mine = half_life(followed.lines[oracle::kTracer]);
    const double best = half_life(followed.lines[oracle::kBestFloats]);
    if (mine >= kLeastOfBestHalf * best) return true;
    (*metrics)["why"] =
        fmt::format("half of the paths are lost by bounce {}, must be {:.1f} at least", mine,
                    kLeastOfBestHalf * best);
    return false;
}

Case summary_of(const Followed& followed, Line line, bool is_smooth) {
    const ErrorTable& table = followed.lines[line];
    Case made = case_of(line, is_smooth, "all");
    made.metrics = {{"paths", table.path_count()},
                    {"lost", table.lost_by(table.bounce_count())},
                    {"tenth_lost_at", bounce_or_null(table.bounce_when_lost(0.1))},
                    {"half_lost_at", bounce_or_null(table.bounce_when_lost(0.5))}};
    if (line == oracle::kTracer)
        made.ok = is_faultless(followed.faults, &made.metrics) &&
                  lasts_as_long_as_the_best(followed, &made.metrics);
    return made;
}

}  // namespace

const char* name_of(Line line) {
    constexpr const char* kNames[] = {"rsh", "best_floats", "offset_alone", "one_rounding"};
    return kNames[line];
}

const char* name_of_normals(bool is_smooth) {
    return is_smooth ? "smooth" : "flat";
}

std::vector<Case> cases_of(const Followed& followed, bool is_smooth) {
    std::vector<Case> cases;
    for (int i = 0; i < oracle::kLineCount; ++i) {
        const Line line = Line(i);
        for (size_t bounce = 1; bounce <= followed.lines[i].bounce_count(); ++bounce)
            cases.push_back(case_at(followed, line, bounce, is_smooth));
        cases.push_back(summary_of(followed, line, is_smooth));
    }
    return cases;
}

}  // namespace bench::mirrors
