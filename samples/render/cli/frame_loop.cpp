// frame_loop.cpp - scene in, frames out.
#include "cli/frame_loop.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/picture_output.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/write_output.hpp"
#include "device/renderer.hpp"
#include "scene/scene_file.hpp"

namespace render {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

// The command line goes before the scene, the scene before the default.
RenderSettings render_settings(const Options& options, const SceneSettings& scene) {
    RenderSettings s;
    s.size = options.size.value_or(scene.size.value_or(s.size));
    s.bounces = options.bounces.value_or(scene.bounces.value_or(s.bounces));
    s.min_weight = options.min_weight.value_or(scene.min_weight.value_or(s.min_weight));
    s.tolerance = static_cast<float>(options.tolerance);
    s.cut = scene.cut.value_or(s.cut);
    s.engine = options.engine;
    s.bound = options.bound;
    s.strategy = options.strategy;
    s.budget = options.budget;
    s.without = options.without;
    s.counts = options.prints_statistics || options.json.has_value();
    return s;
}

// Evenly spaced from the start of the scene's time to its end, both included; a single one is
// the scene's still.
std::vector<double> frame_times(const Options& options, const SceneSettings& scene,
                                const World& world) {
    const Interval span = scene.time.value_or(world.time_span());
    if (options.time) return {*options.time};
    const int count = options.frames.value_or(scene.frames.value_or(1));
    if (count == 1) return {scene.still.value_or(span.start)};
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
        times.push_back(span.start + (span.end - span.start) * i / (count - 1));
    return times;
}

// A time that the scene file itself names is meant.
void warn_of_time(const Options& options, const SceneSettings& scene, const World& world) {
    if (!options.time) return;
    if (scene.time && *options.time >= scene.time->start && *options.time <= scene.time->end)
        return;
    for (const std::string& warning : world.warnings_at(*options.time))
        fmt::print(stderr, "warning: --time: {}\n", warning);
}

RunReport begin_report(const rsh::Device& device, const World& world, const Options& options,
                       const RenderSettings& settings) {
    RunReport report;
    report.device = name_of(device);
    report.platform = platform_of(device);
    cl_uint engine = settings.engine;
    if (engine == RSH_ENGINE_DEFAULT)
        rsh::check(rsh_default_engine(device.rsh(), &engine), "rsh_default_engine");
    report.engine = rsh_engine_name(engine);
    report.strategy = settings.strategy == 0 ? "default" : rsh_strategy_name(settings.strategy);
    report.triangles = world.mesh().triangles.size();
    report.size = settings.size;
    report.bounces = settings.bounces;
    report.tolerance = options.tolerance;
    return report;
}

// Runs a call of the renderer. One that the progress bar cancels was cancelled by a signal.
template <typename Call>
auto run_or_stop(const Call& call) try {
    const auto result = call();
    stop_if_interrupted();
    return result;
} catch (const std::runtime_error&) {
    stop_if_interrupted();
    throw;
}

FrameMeasure render(Renderer& renderer, double time, ProgressBar& progress,
                    PictureOutput& picture) {
    const auto take = [&](const Strip& strip) {
        stop_if_interrupted();
        picture.write(strip);
    };
    const FrameMeasure measure = run_or_stop(
        [&] { return renderer.render(time, &ProgressBar::begin_wave, &progress, take); });
    picture.commit();
    return measure;
}

// What is measured must not contain compiling. Two frames go before: the first makes the bounds,
// and the second one refits them, by kernels that a driver compiles when they are first launched.
void warm_up(Renderer& renderer, double time, ProgressBar& progress, RunReport& report) {
    PictureOutput none;
    const FrameMeasure first = render(renderer, time, progress, none);
    report.first_frame_ms = first.total_ms;
    report.programs_built = first.statistics.programs_built;
    report.programs_loaded = first.statistics.programs_loaded;
    render(renderer, time, progress, none);
}

// Of each wave of a strip of so many pixels; 0: none.
uint32_t audited_rays(const Options& options, uint32_t pixels, int frame) {
    if (frame >= options.checked_frames) return options.audited_rays;
    return (pixels - 1) / options.check_ray_step + 1;
}

PictureOutput picture_of(const Options& options, glm::uvec2 size, int frame, int count) {
    if (!options.out) return {};
    return {frame_path(*options.out, frame, count), size, approximation(options.tolerance)};
}

// Whether the last frame's hits are those of brute force.
bool audit(Renderer& renderer, uint32_t rays, int frame, ProgressBar& progress) {
    const auto seed = static_cast<uint32_t>(frame);
    const rsh_audit_report report = run_or_stop(
        [&] { return renderer.audit(rays, seed, &ProgressBar::begin_wave, &progress); });
    fmt::print("{} of {} hits differ\n", report.differences, report.rays);
    if (report.differences > 0)
        fmt::print("{} missed, {} spurious, {} wrong; first: ray {} of its wave\n",
                   report.missed, report.spurious, report.wrong, report.first_ray);
    return report.differences == 0;
}

void write_reports(const RunReport& report, const Options& options) {
    if (options.prints_statistics) fmt::print("{}", table(report));
    if (options.json) write_output(*options.json, json_text(as_json(report)));
}

}  // namespace

int run(const Options& options) {
    check_outputs(options);
    const auto start = std::chrono::steady_clock::now();
    const SceneDescription scene = read_scenes(options.scenes);
    World world(scene, options.max_texture_pixels);
    for (const std::string& warning : world.warnings())
        fmt::print(stderr, "warning: {}\n", warning);
    warn_of_time(options, scene.settings, world);
    const double load_ms = milliseconds_since(start);
    stop_if_interrupted();

    const rsh::Device device = open_device(options.device);
    const RenderSettings settings = render_settings(options, scene.settings);
    const std::vector<double> times = frame_times(options, scene.settings, world);
    const int count = static_cast<int>(times.size());
    check_pictures(options, count, settings.size);
    Renderer renderer(device, world, settings);
    RunReport report = begin_report(device, world, options, settings);
    report.load_ms = load_ms;
    ProgressBar progress(count);
    if (settings.counts) warm_up(renderer, times[0], progress, report);

    bool is_exact = true;
    for (int i = 0; i < count; ++i) {
        progress.begin_frame(i);
        PictureOutput picture = picture_of(options, settings.size, i, count);
        report.frames.push_back(render(renderer, times[i], progress, picture));
        if (options.layers)
            write_layers(frame_path(*options.layers, i, count), device, world,
                         renderer.frame_desc());
        const uint32_t rays = audited_rays(options, settings.size.x * renderer.strip_rows(), i);
        if (rays > 0) is_exact = audit(renderer, rays, i, progress) && is_exact;
    }
    write_reports(report, options);
    return is_exact ? 0 : 1;
}

}  // namespace render
