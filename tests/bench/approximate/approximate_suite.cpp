// approximate_suite.cpp - chooses scenes, sizes and tolerances, and runs them scene by scene.
#include "approximate/approximate_suite.hpp"

#include <fmt/format.h>

#include <optional>
#include <regex>

#include "approximate/measure.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace approximate;
using accuracy::SceneKind;
using accuracy::Staged;

constexpr float kTolerances[] = {0.003f, 0.01f, 0.03f};

// Quick: within a minute on two cores, once the programs are compiled.
const Amount kQuick = {{240, 480}, 2, 9};
const Amount kUsual = {{480, 960, 1920}, 10, 21};

const std::vector<SceneKind>& scenes() {
    static const std::vector<SceneKind> all = {
        accuracy::file_kind("quickstart", true),
        accuracy::file_kind("cornell_mirror"),
        accuracy::file_kind("cornell_sphere"),
        accuracy::file_kind("chinese_dragon_20k"),
        accuracy::file_kind("dragon_48k"),
        accuracy::file_kind("koala"),
        accuracy::file_kind("kitchen"),
        accuracy::file_kind("gallery"),
        accuracy::room_kind("room_80k", 80000, true),  // needs no file
    };
    return all;
}

struct Selected {
    SceneKind scene;
    std::vector<Picture> pictures;
};

std::vector<Selected> select(bool quick, const Amount& amount, const std::string& filter) {
    const std::regex wanted(filter.empty() ? "." : filter);
    std::vector<Selected> selected;
    for (const SceneKind& scene : scenes()) {
        if (quick && !scene.is_quick) continue;
        Selected one = {scene, {}};
        for (const cl_uint width : amount.widths) {
            Picture picture = {scene.name, width, {}};
            for (const float tolerance : kTolerances)
                if (std::regex_search(picture.case_name(tolerance), wanted))
                    picture.tolerances.push_back(tolerance);
            if (!picture.tolerances.empty()) one.pictures.push_back(picture);
        }
        if (!one.pictures.empty()) selected.push_back(one);
    }
    return selected;
}

void leave_out(const Run& run, const Picture& picture, const std::string& why) {
    for (const float tolerance : picture.tolerances)
        run.results.leave_out(picture.case_name(tolerance), why);
}

void fail(const Run& run, const Picture& picture, const std::string& why) {
    for (const float tolerance : picture.tolerances)
        run.results.add({picture.case_name(tolerance),
                         {{"scene", picture.scene}, {"width", picture.width}},
                         {{"error", why}},
                         false});
}

// What a file is missing for is left out; all else that fails is wrong.
void measure(const Run& run, const Selected& one, const Amount& amount) {
    std::optional<Staged> staged;
    std::string why = run.limit.has_passed() ? run.limit.when_passed() : "";
    try {
        if (why.empty()) staged = one.scene.make();
    } catch (const std::exception& error) {
        why = error.what();
    }
    if (!staged) {
        for (const Picture& picture : one.pictures) leave_out(run, picture, why);
        return;
    }
    const accuracy::SceneOnDevice scene(run.device, *staged);
    for (const Picture& picture : one.pictures) try {
            if (run.limit.has_passed())
                leave_out(run, picture, run.limit.when_passed());
            else
                measure_picture(run, picture, *staged, scene, amount);
        } catch (const std::exception& error) {
            fail(run, picture, describe_error(error));
        }
}

void list(const std::vector<Selected>& selected) {
    for (const Selected& one : selected)
        for (const Picture& picture : one.pictures)
            for (const float tolerance : picture.tolerances)
                fmt::print("{}\n", picture.case_name(tolerance));
}

}  // namespace

void ApproximateSuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void ApproximateSuite::run(const Run& run) {
    const Amount& amount = run.quick ? kQuick : kUsual;
    const std::vector<Selected> selected = select(run.quick, amount, filter_);
    if (lists_) return list(selected);
    ProgressBar progress(selected.size());
    for (const Selected& one : selected) {
        progress.begin(one.scene.name);
        measure(run, one, amount);
    }
}

}  // namespace bench
