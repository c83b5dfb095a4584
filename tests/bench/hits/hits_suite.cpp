// hits_suite.cpp - chooses scenes and contenders, and runs them scene by scene.
#include "hits/hits_suite.hpp"

#include <fmt/format.h>

#include <regex>

#include "hits/measure.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace hits;

// Quick: within a minute on two cores. Usual: all rays of a scene of 20,000 triangles are judged.
constexpr Amount kQuick = {{128, 1500}, 1e8, 1e8, 0.1, 3};
constexpr Amount kUsual = {{256, 20000}, 1.5e9, 1.5e9, 2.0, 5};

struct Selected {
    SceneKind scene;
    std::vector<ContenderKind> contenders;
};

std::vector<Selected> select(const Run& run, const Amount& amount, const std::string& filter) {
    std::vector<ContenderKind> all = rsh_contenders(run.device);
    for (const ContenderKind& peer : peer_contenders()) all.push_back(peer);
    const std::regex wanted(filter.empty() ? "." : filter);
    std::vector<Selected> selected;
    for (const SceneKind& scene : scene_kinds()) {
        if (run.quick && !scene.is_quick) continue;
        Selected one = {scene, {}};
        for (const ContenderKind& contender : all)
            if (std::regex_search(case_name(scene, amount, contender), wanted))
                one.contenders.push_back(contender);
        if (!one.contenders.empty()) selected.push_back(one);
    }
    return selected;
}

void fail(const Run& run, const Selected& one, const Amount& amount, const std::string& why) {
    for (const ContenderKind& contender : one.contenders)
        run.results.add({case_name(one.scene, amount, contender),
                         {{"scene", one.scene.name},
                          {"group", one.scene.group},
                          {"contender", contender.label}},
                         {{"error", why}},
                         false});
}

}  // namespace

void HitsSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_option("--side", side_, "Of the square of rays")->check(CLI::Range(1, 8192));
    app.add_option("--triangles", triangles_,
                   "About, of scenes whose name has no number of them")
        ->check(CLI::Range(64, 1 << 24));
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void HitsSuite::run(const Run& run) {
    Amount amount = run.quick ? kQuick : kUsual;
    if (side_ > 0) amount.extent.side = side_;
    if (triangles_ > 0) amount.extent.triangles = triangles_;
    const std::vector<Selected> selected = select(run, amount, filter_);
    ProgressBar progress(lists_ ? 0 : selected.size());
    for (const Selected& one : selected) {
        if (!lists_) progress.begin(one.scene.name);
        const bool is_late = run.limit.has_passed();
        for (const ContenderKind& contender : one.contenders) {
            const std::string name = case_name(one.scene, amount, contender);
            if (lists_) fmt::print("{}\n", name);
            if (!lists_ && is_late) run.results.leave_out(name, run.limit.when_passed());
        }
        if (lists_ || is_late) continue;
        try {
            measure_scene(run, one.scene, one.contenders, amount);
        } catch (const std::exception& error) {
            fail(run, one, amount, describe_error(error));
        }
    }
}

}  // namespace bench
