// report.cpp - the breakdown of time, rays per bounce and pairs per level.
#include "cli/report.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <nlohmann/json.hpp>

namespace render {
namespace {

constexpr size_t kLevels = RSH_MAX_LEVELS + 1;

struct NamedStage {
    int stage;
    const char* name;
    const char* key;
};
constexpr std::array<NamedStage, 8> kNamedStages{{
    {RSH_STAGE_RASTERIZE, "rasterization", "rasterize"},
    {RSH_STAGE_BOUND, "bounds", "bound"},
    {RSH_STAGE_SPAWN, "secondary rays", "spawn"},
    {RSH_STAGE_BUILD, "hierarchy", "build"},
    {RSH_STAGE_TEST, "cone-sphere tests", "test"},
    {RSH_STAGE_REDUCE, "reduction", "reduce"},
    {RSH_STAGE_INTERSECT, "ray-triangle", "intersect"},
    {RSH_STAGE_SHADE, "shading", "shade"},
}};

double mean(const RunReport& report, const std::function<double(const FrameMeasure&)>& value) {
    double sum = 0.0;
    for (const FrameMeasure& frame : report.frames) sum += value(frame);
    return sum / static_cast<double>(report.frames.size());
}

// Levels or bounces up to the last one that is not 0 in any frame, as means.
std::string series(const RunReport& report, cl_ulong (rsh_statistics::*counts)[kLevels]) {
    std::string line;
    std::string zeroes;
    for (size_t i = 0; i < kLevels; ++i) {
        const double value = mean(report, [&](const FrameMeasure& frame) {
            return static_cast<double>((frame.statistics.*counts)[i]);
        });
        zeroes += fmt::format(" {:.0f}", value);
        if (value == 0.0) continue;
        line += zeroes;
        zeroes.clear();
    }
    return line.empty() ? " 0" : line;
}

std::string row(const RunReport& report, const char* name, cl_ulong rsh_statistics::*count) {
    const double value = mean(report, [&](const FrameMeasure& frame) {
        return static_cast<double>(frame.statistics.*count);
    });
    return fmt::format("{:<22}{:>12.0f}\n", name, value);
}

std::string stage_rows(const RunReport& report) {
    std::string text;
    const double total = mean(report, [](const FrameMeasure& f) { return f.total_ms; });
    for (size_t i = 0; i <= kNamedStages.size(); ++i) {
        const double ms =
            mean(report, [i](const FrameMeasure& frame) { return stage_times(frame)[i].ms; });
        text += fmt::format("{:<22}{:>12.3f} ms {:>5.1f} %\n",
                            stage_times(report.frames[0])[i].name, ms, 100.0 * ms / total);
    }
    return text + fmt::format("{:<22}{:>12.3f} ms of host time per frame\n", "total", total);
}

nlohmann::json stages_json(const FrameMeasure& frame) {
    nlohmann::json stages;
    for (const StageTime& stage : stage_times(frame)) stages[stage.key] = stage.ms;
    return stages;
}

nlohmann::json frame_json(const FrameMeasure& frame) {
    const rsh_statistics& s = frame.statistics;
    return {{"time", frame.time},
            {"upload_ms", frame.upload_ms},
            {"upload_bytes", frame.upload_bytes},
            {"total_ms", frame.total_ms},
            {"read_ms", frame.read_ms},
            {"resident_bytes", frame.resident_bytes},
            {"stages_ms", stages_json(frame)},
            {"launches", s.launches},
            {"host_waits", s.host_waits},
            {"programs_built", s.programs_built},
            {"programs_loaded", s.programs_loaded},
            {"traversals", s.traversals},
            {"batches", s.batches},
            {"pairs_tested", s.pairs_tested},
            {"pairs_walked", s.pairs_walked},
            {"peak_pairs", s.peak_pairs},
            {"active_rays", s.active_rays},
            {"shadow_rays", s.shadow_rays},
            {"scratch_bytes", s.scratch_bytes}};
}

}  // namespace

std::vector<StageTime> stage_times(const FrameMeasure& frame) {
    std::vector<StageTime> times;
    double other = frame.total_ms;
    for (const NamedStage& stage : kNamedStages) {
        const double ms = 1e-6 * static_cast<double>(frame.statistics.stage_ns[stage.stage]);
        times.push_back({stage.name, stage.key, ms});
        other -= ms;
    }
    times.push_back({"other", "other", other});
    return times;
}

std::string approximation(double tolerance) {
    return tolerance > 0 ? fmt::format("approximate: tolerance {}", tolerance) : "";
}

std::string table(const RunReport& report) {
    std::string text = fmt::format("{} ({}), engine {}, strategy {}\n", report.device,
                                   report.platform, report.engine, report.strategy);
    text +=
        fmt::format("{} triangles, {} x {} pixels, {} bounces, {} frames\n", report.triangles,
                    report.size.x, report.size.y, report.bounces, report.frames.size());
    if (report.tolerance > 0) text += approximation(report.tolerance) + '\n';
    text += fmt::format(
        "scene read in {:.0f} ms; first frame {:.0f} ms, not counted below: {} "
        "programs compiled, {} from the cache\n",
        report.load_ms, report.first_frame_ms, report.programs_built, report.programs_loaded);
    text += fmt::format("{:<22}{}\n", "rays per bounce",
                        series(report, &rsh_statistics::active_rays));
    text +=
        fmt::format("{:<22}{}\n", "shadow rays", series(report, &rsh_statistics::shadow_rays));
    text += fmt::format("{:<22}{}\n", "pairs per level 0..",
                        series(report, &rsh_statistics::pairs_tested));
    text += row(report, "longest stream", &rsh_statistics::peak_pairs);
    text += row(report, "launches", &rsh_statistics::launches);
    text += row(report, "host waits", &rsh_statistics::host_waits);
    text += row(report, "traversals", &rsh_statistics::traversals);
    text += row(report, "batches", &rsh_statistics::batches);
    text += row(report, "scratch bytes", &rsh_statistics::scratch_bytes);
    return text + stage_rows(report);
}

nlohmann::json as_json(const RunReport& report) {
    nlohmann::json frames = nlohmann::json::array();
    for (const FrameMeasure& frame : report.frames) frames.push_back(frame_json(frame));
    return {{"device", report.device},
            {"platform", report.platform},
            {"engine", report.engine},
            {"strategy", report.strategy},
            {"triangles", report.triangles},
            {"width", report.size.x},
            {"height", report.size.y},
            {"bounces", report.bounces},
            {"tolerance", report.tolerance},
            {"load_ms", report.load_ms},
            {"first_frame_ms", report.first_frame_ms},
            {"programs_built", report.programs_built},
            {"programs_loaded", report.programs_loaded},
            {"total",
             "host time from the call of rsh_frame to the end of its last command; stage "
             "\"other\" is this total less the named stages"},
            {"frames", frames}};
}

std::string json_text(const nlohmann::json& json) {
    // Names of files may hold bytes that are not UTF-8.
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace render
