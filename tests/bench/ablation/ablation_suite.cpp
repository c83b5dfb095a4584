// ablation_suite.cpp - chooses features, and measures one after the other.
#include "ablation/ablation_suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "ablation/measure.hpp"
#include "progress.hpp"
#include "queries/layers.hpp"

namespace bench {
namespace {

using namespace ablation;

// Quick: within a minute on two cores, once the programs are on disk.
constexpr Amount kQuick = {128, 96, 8000, 96, 21, false};
constexpr Amount kUsual = {512, 384, 80000, 512, 21, true};

Stage stage_of(const Device& device, const Amount& amount) {
    stability::Scene layers = queries::layers(amount.triangles, amount.ray_side, true);
    const size_t most_hits = 4 * layers.rays.rays.size();
    return {device, amount.width, amount.height, std::move(layers), most_hits};
}

std::vector<Feature> select(const std::string& filter) {
    const std::regex wanted(filter.empty() ? "." : filter);
    std::vector<Feature> all = frame_features();
    for (Feature& feature : ray_features()) all.push_back(std::move(feature));
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const Feature& feature) {
                                 return !std::regex_search(feature.name, wanted);
                             }),
              all.end());
    return all;
}

void leave_out(const Run& run, const Feature& feature, const std::string& why) {
    for (const State& state : feature.states)
        run.results.leave_out(case_name(feature, state), why);
}

void fail(const Run& run, const Feature& feature, const std::string& why) {
    for (const State& state : feature.states)
        if (state.make)
            run.results.add({case_name(feature, state),
                             {{"feature", feature.name}, {"state", state.name}},
                             {{"error", why}},
                             false});
}

}  // namespace

void AblationSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_,
                   "Only features whose name has a match of this expression");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void AblationSuite::run(const Run& run) {
    const std::vector<Feature> features = select(filter_);
    if (lists_) {
        for (const Feature& feature : features)
            for (const State& state : feature.states)
                if (state.make) fmt::print("{}\n", case_name(feature, state));
        return;
    }
    const Amount amount = run.quick ? kQuick : kUsual;
    const Stage stage = stage_of(run.device, amount);
    CompiledBy known;
    ProgressBar progress(features.size());
    for (const Feature& feature : features) {
        progress.begin(feature.name);
        if (run.limit.has_passed()) {
            leave_out(run, feature, run.limit.when_passed());
            continue;
        }
        try {
            measure(run, stage, feature, amount, known);
        } catch (const std::exception& error) {
            fail(run, feature, describe_error(error));
        }
    }
}

}  // namespace bench
