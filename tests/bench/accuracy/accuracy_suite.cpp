// accuracy_suite.cpp - chooses scenes and points, and runs them scene by scene.
#include "accuracy/accuracy_suite.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <regex>

#include "accuracy/measure.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace accuracy;

// Quick: within a minute on two cores, once the programs are compiled.
constexpr uint32_t kQuickWidth = 96, kUsualWidth = 256;

Amount amount_of(bool quick, uint32_t width, const std::string& pictures) {
    if (width == 0) width = quick ? kQuickWidth : kUsualWidth;
    const uint32_t height = width / 4 * 3;
    if (quick) return {width, height, 2e8, 5e8, 8, 21, pictures};
    return {width, height, 1e9, 5e8, 10, 21, pictures};
}

struct Selected {
    SceneKind scene;
    std::vector<Point> points;
};

// Whatever is chosen, the default is there: ratios are to it.
std::vector<Selected> select(bool quick, const std::string& filter) {
    const std::regex wanted(filter.empty() ? "." : filter);
    std::vector<Selected> selected;
    for (const SceneKind& scene : scene_kinds()) {
        if (quick && !scene.is_quick) continue;
        Selected one = {scene, {all_points().front()}};
        bool is_wanted = std::regex_search(case_name(scene, one.points[0]), wanted);
        for (size_t i = 1; i < all_points().size(); ++i) {
            const Point& point = all_points()[i];
            if (quick && !point.is_quick) continue;
            if (!std::regex_search(case_name(scene, point), wanted)) continue;
            one.points.push_back(point);
            is_wanted = true;
        }
        if (is_wanted) selected.push_back(one);
    }
    return selected;
}

void leave_out(const Run& run, const Selected& one, const std::string& why) {
    for (const Point& point : one.points)
        run.results.leave_out(case_name(one.scene, point), why);
}

void fail(const Run& run, const Selected& one, const std::string& why) {
    for (const Point& point : one.points)
        run.results.add(
            {case_name(one.scene, point),
             {{"scene", one.scene.name}, {"axis", point.axis}, {"value", point.value}},
             {{"error", why}},
             false});
}

// What a file is missing for is left out; all else that fails is wrong.
void measure(const Run& run, const Selected& one, const Amount& amount) {
    if (run.limit.has_passed()) return leave_out(run, one, run.limit.when_passed());
    std::optional<Staged> staged;
    try {
        staged = one.scene.make();
    } catch (const std::exception& error) {
        return leave_out(run, one, error.what());
    }
    try {
        measure_scene(run, one.scene, *staged, one.points, amount);
    } catch (const std::exception& error) {
        fail(run, one, describe_error(error));
    }
}

}  // namespace

void AccuracySuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_,
                   "Only cases whose name has a match of this expression, and the default of "
                   "their scenes");
    app.add_option("--width", width_,
                   "Of the default picture, which is 4 : 3; a multiple of 16")
        ->check(CLI::Range(16, 2048))
        ->check([](const std::string& text) {
            return std::stoul(text) % 16 == 0 ? "" : "must be a multiple of 16, is " + text;
        });
    app.add_option("--pictures", pictures_, "Write the pictures into this folder, as PPM");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void AccuracySuite::run(const Run& run) {
    const Amount amount = amount_of(run.quick, width_, pictures_);
    const std::vector<Selected> selected = select(run.quick, filter_);
    if (!lists_ && !pictures_.empty()) std::filesystem::create_directories(pictures_);
    ProgressBar progress(lists_ ? 0 : selected.size());
    for (const Selected& one : selected) {
        if (lists_)
            for (const Point& point : one.points)
                fmt::print("{}\n", case_name(one.scene, point));
        if (lists_) continue;
        progress.begin(one.scene.name);
        measure(run, one, amount);
    }
}

}  // namespace bench
