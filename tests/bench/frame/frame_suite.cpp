// frame_suite.cpp - chooses rows and columns, reads each scene once, prints a line per case.
#include "frame/frame_suite.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <regex>

#include "frame/build_rows.hpp"
#include "frame/frame_measure.hpp"
#include "frame/frame_peer.hpp"
#include "frame/frame_summary.hpp"
#include "progress.hpp"

namespace bench {
namespace {

template <class Row>
struct Selected {
    Row row;
    std::vector<Column> columns;
};

struct Selection {
    std::vector<Selected<FrameRow>> frames;
    std::vector<Selected<BuildRow>> builds;
};

template <class Row>
void add(std::vector<Selected<Row>>& selected, const Row& row,
         const std::vector<Column>& columns, const std::regex& wanted) {
    Selected<Row> one = {row, {}};
    for (const Column& column : columns)
        if (is_measured(row, column) && std::regex_search(case_name(row, column), wanted))
            one.columns.push_back(column);
    if (!one.columns.empty()) selected.push_back(one);
}

Selection select(const Device& device, const std::string& filter, bool quick) {
    const std::vector<Column> columns = frame_columns(device);
    const std::regex wanted(filter.empty() ? "." : filter);
    Selection selection;
    for (const FrameRow& row : frame_rows())
        if (row.is_quick || !quick) add(selection.frames, row, columns, wanted);
    for (const BuildRow& row : build_rows()) add(selection.builds, row, columns, wanted);
    return selection;
}

void list(const Selection& selection) {
    const auto print_all = [](const auto& rows) {
        for (const auto& [row, columns] : rows)
            for (const Column& column : columns) fmt::print("{}\n", case_name(row, column));
    };
    print_all(selection.frames);
    print_all(selection.builds);
}

void print_wrong(const Case& c) {
    fmt::print("{}\n    not timed: {} mismatches\n", c.name,
               c.metrics["mismatches"].get<size_t>());
}

void print_build(const Case& c) {
    const nlohmann::json& m = c.metrics;
    fmt::print("{}\n    build {:.2f} ms, copy {:.2f} ms: {:.2f} times; {} mismatches\n", c.name,
               m["ms_build"].get<double>(), m["ms_copy"].get<double>(),
               m["build_over_copy"].get<double>(), m["mismatches"].get<size_t>());
}

void print_frame(const Case& c) {
    const nlohmann::json& m = c.metrics;
    fmt::print(
        "{}\n    {:.2f} ms (bound {:.2f}, build {:.2f}, traverse {:.2f}){}; "
        "{:.0f} tests/ray, {} mismatches\n",
        c.name, m["ms_total"].get<double>(), m["ms_bound"].get<double>(),
        m["ms_build"].get<double>(), m["ms_traverse"].get<double>(), frame_peer_text(m),
        m["tests_per_ray"].get<double>(), m["mismatches"].get<size_t>());
    std::fflush(stdout);
}

// The scene that was read last: rows of one scene stand together.
class SceneShelf {
public:
    explicit SceneShelf(const Device& device) : device_(device) {}

    // Null, after a word about it, when files are missing.
    SceneOnDevice* get(const SceneSpec& spec) {
        if (spec.name == name_) return on_device_.get();
        name_ = spec.name;
        on_device_.reset();
        try {
            scene_ = std::make_unique<FrameScene>(spec);
            on_device_ = std::make_unique<SceneOnDevice>(device_, *scene_);
        } catch (const std::runtime_error& error) {
            fmt::print(stderr, "left out: scene {}: {}\n", spec.name, error.what());
        }
        return on_device_.get();
    }

private:
    const Device& device_;
    std::string name_;
    std::unique_ptr<FrameScene> scene_;
    std::unique_ptr<SceneOnDevice> on_device_;
};

}  // namespace

void FrameSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

std::vector<Case> FrameSuite::run(const Run& run) {
    const Selection selection = select(run.device, filter_, run.quick);
    if (lists_) {
        list(selection);
        return {};
    }
    const RowSettings settings = {run.quick ? 0.7 : 3.0, run.quick ? size_t{3} : size_t{5}};
    std::vector<Case> cases;
    SceneShelf shelf(run.device);
    ProgressBar progress(selection.frames.size() + selection.builds.size());
    for (const auto& [row, columns] : selection.frames) {
        progress.begin(row.name());
        SceneOnDevice* scene = shelf.get(row.scene);
        if (!scene) continue;
        const std::vector<Case> measured =
            measure_row(run.device, *scene, row, columns, settings);
        if (measured.empty()) fmt::print("{}: the scene has no such rays\n", row.name());
        for (const Case& c : measured) c.ok ? print_frame(c) : print_wrong(c);
        cases.insert(cases.end(), measured.begin(), measured.end());
    }
    for (const auto& [row, columns] : selection.builds) {
        progress.begin(row.name());
        SceneOnDevice* scene = shelf.get(row.scene);
        for (const Column& column : columns) {
            cases.push_back(
                measure_build(run.device, *scene, row, column, run.quick ? 21 : 51));
            cases.back().ok ? print_build(cases.back()) : print_wrong(cases.back());
        }
    }
    const std::vector<Case> summaries = summarize(cases);
    for (const Case& summary : summaries) fmt::print("{}", as_text(summary));
    cases.insert(cases.end(), summaries.begin(), summaries.end());
    return cases;
}

}  // namespace bench
