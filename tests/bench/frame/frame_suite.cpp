// frame_suite.cpp - chooses rows and columns, and runs them row by row.
#include "frame/frame_suite.hpp"

#include <fmt/format.h>

#include <regex>

#include "frame/build_rows.hpp"
#include "frame/frame_measure.hpp"
#include "frame/frame_summary.hpp"
#include "frame/frame_text.hpp"
#include "frame/scene_shelf.hpp"
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

Selection select(const std::vector<Column>& columns, const std::string& filter, bool quick) {
    const std::regex wanted(filter.empty() ? "." : filter);
    Selection selection;
    for (const FrameRow& row : frame_rows())
        if (row.is_quick || !quick) add(selection.frames, row, columns, wanted);
    for (const BuildRow& row : build_rows()) add(selection.builds, row, columns, wanted);
    return selection;
}

// Nothing that was there a frame ago is refitted.
Selection select_device(const std::vector<Column>& all, const std::string& filter) {
    std::vector<Column> columns;
    for (const Column& column : all)
        if (!column.is_refit) columns.push_back(column);
    Selection selection;
    for (const FrameRow& row : device_rows())
        add(selection.frames, row, columns, std::regex(filter.empty() ? "." : filter));
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

DevicesByWidth devices_of(const Device& device, const std::vector<cl_uint>& widths) {
    DevicesByWidth devices;
    if (widths.empty()) devices.emplace(0, Device(device, 0));
    for (const cl_uint width : widths) devices.emplace(width, Device(device, width));
    return devices;
}

class FrameMeasurement {
public:
    FrameMeasurement(const Run& run, const DevicesByWidth& devices, const Selection& selection,
                     const RowSettings& settings)
        : run_{run, devices, settings, {}},
          shelf_(run.device),
          progress_(selection.frames.size() + selection.builds.size()) {}

    void measure(const Selection& selection) {
        for (const auto& one : selection.frames)
            start(one.row, one.columns, [&](SceneOnDevice& scene) {
                measure_row(run_, scene, one.row, one.columns);
            });
        for (const auto& one : selection.builds)
            for (const Column& column : one.columns)
                start(one.row, {column},
                      [&](SceneOnDevice& scene) { build(scene, one.row, column); });
    }

private:
    // A scene whose files are missing, or that does not fit, is left out.
    template <class Row, class Measure>
    void start(const Row& row, const std::vector<Column>& columns, const Measure& measure) {
        progress_.begin(row.name());
        std::string why;
        if (run_.run.limit.has_passed()) why = run_.run.limit.when_passed();
        SceneOnDevice* scene = nullptr;
        try {
            if (why.empty()) scene = &shelf_.get(row.scene);
        } catch (const std::exception& error) {
            why = describe_error(error);
        }
        if (!scene) {
            for (const Column& column : columns)
                run_.run.results.leave_out(case_name(row, column), why);
            return;
        }
        try {
            measure(*scene);
        } catch (const std::exception& error) {
            fail(row, columns, describe_error(error));
        }
    }

    // What no column could be told apart from: rays could not be made, or a frame failed that had
    // been right before. Other rows may do.
    template <class Row>
    void fail(const Row& row, const std::vector<Column>& columns, const std::string& why) {
        for (const Column& column : columns) {
            const Case failed = {case_name(row, column),
                                 {{"scene", row.scene.name},
                                  {"width", row.size.width},
                                  {"height", row.size.height},
                                  {"rays", name_of(row.rays)},
                                  {"engine", column.engine_name},
                                  {"bound", column.bound_name},
                                  {"refit", column.is_refit},
                                  {"vector_width", column.vector_width}},
                                 {{"error", why}},
                                 false};
            print_frame(failed);
            run_.run.results.add(failed);
        }
    }

    void build(SceneOnDevice& scene, const BuildRow& row, const Column& column) {
        const size_t pairs = run_.run.quick ? 21 : 51;
        const Case done =
            measure_build(run_.devices.at(column.vector_width), scene, row, column, pairs);
        print_build(done);
        run_.run.results.add(done);
    }

    FrameRun run_;
    SceneShelf shelf_;
    ProgressBar progress_;
};

}  // namespace

void FrameSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_option("--rows", rows_,
                   "standard, or device: three rooms at four sizes, every engine, small ones "
                   "first")
        ->check(CLI::IsMember({"standard", "device"}));
    app.add_option("--vector-width", widths_,
                   "Of the kernels, several with commas: each column with each of them in turn")
        ->delimiter(',')
        ->check(CLI::IsMember({1, 4, 8, 16}));
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void FrameSuite::run(const Run& run) {
    const bool is_brief = run.quick || rows_ == "device";
    const std::vector<Column> columns = with_widths(frame_columns(run.device), widths_);
    const Selection selection = rows_ == "device" ? select_device(columns, filter_)
                                                  : select(columns, filter_, run.quick);
    if (lists_) return list(selection);
    const DevicesByWidth devices = devices_of(run.device, widths_);
    FrameMeasurement(run, devices, selection,
                     {is_brief ? 0.7 : 3.0, is_brief ? size_t{3} : size_t{5}})
        .measure(selection);
    for (const Case& summary : summarize(run.results.cases())) {
        fmt::print("{}", as_text(summary));
        run.results.add(summary);
    }
}

}  // namespace bench
