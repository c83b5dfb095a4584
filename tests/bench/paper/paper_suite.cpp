// paper_suite.cpp - chooses rows and engines, and runs them row by row.
#include "paper/paper_suite.hpp"

#include <fmt/format.h>

#include <memory>
#include <regex>

#include "paper/batches/batches_rows.hpp"
#include "paper/build_row.hpp"
#include "paper/cones/sphere_row.hpp"
#include "paper/measure.hpp"
#include "paper/rows.hpp"
#include "paper/summary.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace paper;

// Quick: within a minute on two cores, once the programs are compiled.
const Amount kQuick = {0.5, 5, 5, 1e7};
const Amount kUsual = {4, 60, 12, 1e8};
constexpr size_t kQuickPairs = 11, kUsualPairs = 51;

struct Selected {
    Row row;
    std::vector<std::string> engines;
};

struct Selection {
    std::vector<Selected> rows;
    std::vector<std::string> builds;   // engines of the row `build`
    std::vector<std::string> spheres;  // cases of the row `sphere_for_triangle`
    std::vector<std::string> batches;  // cases of the rows of scenes in batches
};

// Names of cases that are asked for.
class Filter {
public:
    Filter(bool quick, const std::string& expression)
        : quick_(quick), wanted_(expression.empty() ? "." : expression) {}

    bool has(const std::string& name) const { return std::regex_search(name, wanted_); }
    // name_of: of a case, by its engine.
    template <class NameOf>
    std::vector<std::string> engines(const NameOf& name_of) const {
        std::vector<std::string> found;
        for (const std::string engine : kEngines)
            if ((!quick_ || engine == "tiles") && has(name_of(engine))) found.push_back(engine);
        return found;
    }

private:
    bool quick_;
    std::regex wanted_;
};

Selection select(bool quick, const std::string& expression) {
    const Filter filter(quick, expression);
    Selection selection;
    selection.builds = filter.engines(build_case_name);
    for (const std::string& name : sphere_case_names())
        if (!quick && filter.has(name)) selection.spheres.push_back(name);
    for (const std::string& name : batches_case_names(quick))
        if (filter.has(name)) selection.batches.push_back(name);
    for (const Row& row : rows()) {
        if (quick && !row.is_quick) continue;
        Selected one = {row, {}};
        for (const std::string& engine :
             filter.engines([&](const std::string& engine) { return case_name(row, engine); }))
            if (row.takes(engine)) one.engines.push_back(engine);
        if (!one.engines.empty()) selection.rows.push_back(one);
    }
    return selection;
}

void list(const Selection& selection) {
    for (const std::string& engine : selection.builds)
        fmt::print("{}\n", build_case_name(engine));
    for (const std::string& name : selection.spheres) fmt::print("{}\n", name);
    for (const std::string& name : selection.batches) fmt::print("{}\n", name);
    for (const Selected& one : selection.rows)
        for (const std::string& engine : one.engines)
            fmt::print("{}\n", case_name(one.row, engine));
}

// A scene whose files are missing is left out.
void measure(const Run& run, Estimate& estimate, const Selected& one, const Amount& amount) {
    std::string why = run.limit.has_passed() ? run.limit.when_passed() : "";
    std::unique_ptr<MovingScene> scene;
    try {
        if (why.empty()) scene = open_scene(one.row.scene);
    } catch (const std::exception& error) {
        why = describe_error(error);
    }
    if (scene) return measure_row(run, estimate, one.row, *scene, one.engines, amount);
    for (const std::string& engine : one.engines)
        run.results.leave_out(case_name(one.row, engine), why);
}

}  // namespace

void PaperSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void PaperSuite::run(const Run& run) {
    const Selection selection = select(run.quick, filter_);
    if (lists_) return list(selection);
    const Amount& amount = run.quick ? kQuick : kUsual;
    ProgressBar progress(selection.rows.size() + 2);
    progress.begin(kBuildRow);
    measure_builds(run, selection.builds, run.quick ? kQuickPairs : kUsualPairs);
    progress.begin("batches");
    measure_out_of_core(run, selection.batches);
    measure_batches(run, selection.batches, amount);
    measure_spheres(run, selection.spheres);
    Estimate estimate;
    for (const Selected& one : selection.rows) {
        progress.begin(one.row.name);
        measure(run, estimate, one, amount);
    }
    for (const Case& summary : summarize(run.results.cases())) {
        fmt::print("{}", as_text_of_summary(summary));
        run.results.add(summary);
    }
}

}  // namespace bench
