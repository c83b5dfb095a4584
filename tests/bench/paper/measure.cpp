#include "paper/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>

#include "accuracy/scene_on_device.hpp"
#include "paper/frame.hpp"
#include "paper/paper_text.hpp"
#include "paper/reflectors.hpp"
#include "paper/scenes.hpp"
#include "scene/device_structs.hpp"
#include "timing.hpp"

namespace bench::paper {
namespace {

using nlohmann::json;

// One moment of a row's scene, in buffers.
class Moment {
public:
    Moment(const Device& device, StillScene scene, const Row& row)
        : device_(device),
          still_(std::move(scene)),
          staged_(accuracy::staged(still_)),
          on_device_(device, with_aspect(row.size)),
          scene_(on_device_.without(features_without(row))) {}

    const StillScene& still() const { return still_; }
    const accuracy::SceneOnDevice& on_device() const { return on_device_; }
    void place_in(Frame& frame) const { frame.place(scene_, on_device_.camera()); }

    // Milliseconds to send what moves to the device once more: positions and normals.
    double upload() const {
        const render::Mesh& mesh = still_.mesh;
        return milliseconds([&] {
            send(scene_.geometry.vertices, mesh.positions);
            send(scene_.normals, mesh.normals);
        });
    }

private:
    // The paper's rays: reflections, and shadows where it tells of them.
    static rsh_features features_without(const Row& row) {
        return RSH_FEATURE_REFRACTION | (row.has_shadows ? 0 : RSH_FEATURE_SHADOW);
    }
    const accuracy::Staged& with_aspect(Size size) {
        staged_.camera =
            render::device_camera(still_.camera, float(size.width) / float(size.height));
        return staged_;
    }
    void send(cl_mem buffer, const std::vector<glm::vec3>& items) const {
        if (buffer && !items.empty())
            device_.queue().enqueueWriteBuffer(cl::Buffer(buffer, true), CL_TRUE, 0,
                                               items.size() * sizeof(glm::vec3), items.data());
    }

    const Device& device_;
    StillScene still_;
    accuracy::Staged staged_;
    accuracy::SceneOnDevice on_device_;
    rsh_scene scene_;
};

constexpr double kSlowMs = 3000;

struct Times {
    std::vector<double> frame_ms, ms;
    std::vector<FrameWork> works;
};

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           double(std::max<size_t>(values.size(), 1));
}

// The median where nothing moves, else the animation's mean.
double typical(const Row& row, const std::vector<double>& values) {
    return row.scene.moves ? mean(values) : spread(values).median;
}

double stage(const Times& times, std::initializer_list<int> stages) {
    double sum = 0;
    for (const FrameWork& work : times.works)
        for (const int i : stages) sum += work.stage_ms[size_t(i)];
    return sum / double(times.works.size());
}

// Shares of the frames that were counted; `other` is all that has no name here: the camera's rays,
// spawning, clears, and waits of the host.
json shares(const Times& times) {
    double whole = 0;
    for (const FrameWork& work : times.works)
        whole += work.frame_ms / double(times.works.size());
    json found = {{"share_build", stage(times, {RSH_STAGE_BOUND, RSH_STAGE_BUILD}) / whole},
                  {"share_tests", stage(times, {RSH_STAGE_TEST}) / whole},
                  {"share_reduction", stage(times, {RSH_STAGE_REDUCE}) / whole},
                  {"share_intersect", stage(times, {RSH_STAGE_INTERSECT}) / whole},
                  {"share_shade", stage(times, {RSH_STAGE_SHADE}) / whole}};
    double named = 0;
    for (const json& share : found) named += share.get<double>();
    found["share_other"] = 1 - named;
    return found;
}

json counts(const Times& times) {
    double node_tests = 0, ray_tests = 0, batches = 0, rays = 0;
    cl_ulong pairs = 0;
    const double n = double(times.works.size());
    for (const FrameWork& work : times.works) {
        const rsh_statistics& s = work.statistics;
        node_tests += double(s.node_tests) / n;
        ray_tests += double(s.ray_tests) / n;
        batches = std::max(batches, work.batches());
        pairs = std::max(pairs, s.peak_pairs);
        for (size_t i = 1; i <= RSH_MAX_LEVELS; ++i) rays += double(s.active_rays[i]) / n;
        for (const cl_ulong shadow : s.shadow_rays) rays += double(shadow) / n;
    }
    return {{"batches", batches},
            {"pairs_peak", pairs},
            {"node_tests", node_tests},
            {"ray_tests", ray_tests},
            {"rays", rays}};
}

// Of the first frame, with the engine paper_faithful: the pairs of triangles and nodes by level, [0] those
// of triangles and rays.
json pairs_by_level(const Times& times) {
    const cl_ulong* found = times.works.front().statistics.pairs_tested;
    std::vector<cl_ulong> pairs(found, found + RSH_MAX_LEVELS + 1);
    while (!pairs.empty() && pairs.back() == 0) pairs.pop_back();
    return pairs;
}

json times_of(const Row& row, const Times& times) {
    json found = {{"ms", typical(row, times.ms)},
                  {"ms_low", spread(times.ms).low},
                  {"ms_high", spread(times.ms).high},
                  {"frame_ms", typical(row, times.frame_ms)},
                  {"frame_ms_low", spread(times.frame_ms).low},
                  {"frame_ms_high", spread(times.frame_ms).high},
                  {"ms_bound", stage(times, {RSH_STAGE_BOUND})},
                  {"ms_build", stage(times, {RSH_STAGE_BUILD})},
                  {"ms_tests", stage(times, {RSH_STAGE_TEST})},
                  {"ms_reduction", stage(times, {RSH_STAGE_REDUCE})},
                  {"ms_intersect", stage(times, {RSH_STAGE_INTERSECT})},
                  {"frames", times.ms.size()}};
    found.update(shares(times));
    found.update(counts(times));
    const json pairs = pairs_by_level(times);
    if (!pairs.empty()) found["pairs_by_level"] = pairs;
    if (row.paper_ms)
        found.update({{"paper_ms", *row.paper_ms},
                      {"speedup", *row.paper_ms / found["ms"].get<double>()}});
    if (row.scene.moves)
        found.update({{"ms_by_frame", times.ms}, {"frame_ms_by_frame", times.frame_ms}});
    return found;
}

class RowRun {
public:
    RowRun(const Run& run, Estimate& estimate, const Row& row, const Amount& amount)
        : run_(run),
          estimate_(estimate),
          row_(row),
          amount_(amount),
          scene_(open_scene(row.scene)) {
        move_to(0.5);
        params_ = {{"row", row_.name},
                   {"scene", row_.scene.name},
                   {"triangles", moment_->still().mesh.triangles.size()},
                   {"width", row_.size.width},
                   {"height", row_.size.height},
                   {"bounces", row_.bounces},
                   {"shadows", row_.has_shadows},
                   {"batches", 1}};
        if (row_.scene.source == Source::kLayers) params_["layers"] = row_.scene.layers;
        if (!row_.strategy.empty()) params_["strategy"] = row_.strategy;
        look();
    }

    void measure(const std::string& engine);

private:
    void move_to(double fraction) {
        moment_.reset();
        moment_ = std::make_unique<Moment>(run_.device, scene_->at(fraction), row_);
    }
    size_t frames(const std::string& engine) const {
        return engine == "tiles" ? amount_.frames : amount_.slow_frames;
    }
    double work() const {
        return double(row_.size.pixels()) + params_["triangles"].get<double>();
    }
    std::string why_not(const std::string& engine, Frame& frame) const;
    FrameSettings settings(const std::string& engine) const;
    void look();
    std::string shortfall() const;
    bool check(Frame& frame, json& metrics) const;
    void time_frame(Frame& frame, size_t frame_number, size_t count, Times& times);
    Times time(Frame& frame, size_t most);

    const Run& run_;
    Estimate& estimate_;
    const Row& row_;
    const Amount& amount_;
    std::unique_ptr<MovingScene> scene_;
    std::unique_ptr<Moment> moment_;
    json params_;
};

FrameSettings RowRun::settings(const std::string& engine) const {
    FrameSettings made = {row_.size, row_.bounces};
    rsh::check(rsh_engine_from_name(engine.c_str(), &made.engine), "rsh_engine_from_name");
    if (!row_.strategy.empty())
        rsh::check(rsh_strategy_from_name(row_.strategy.c_str(), &made.strategy),
                   "rsh_strategy_from_name");
    return made;
}

std::string RowRun::why_not(const std::string& engine, Frame& frame) const {
    const std::string why = estimate_.refusal(run_.limit, engine, work());
    return why.empty() ? memory_refusal(run_.device.memory(), frame.needs(), 0) : why;
}

// What the row's stand-in is like, by a frame of the quickest engine.
void RowRun::look() {
    Frame frame(run_.device, settings("tiles"));
    moment_->place_in(frame);
    frame.allocate();
    const rsh_statistics counted = frame.count().statistics;
    params_["spawn_share"] = double(counted.active_rays[1]) / double(row_.size.pixels());
    if (row_.least_reflectors == 0) return;
    std::vector<rsh_hit> hits;
    moment_->on_device().first_rays(row_.size.width, row_.size.height, &hits);
    params_["reflectors"] = count_reflectors(moment_->still(), hits);
}

// Why the stand-in is not as demanding as the paper's scene; empty: it is.
std::string RowRun::shortfall() const {
    const double share = params_["spawn_share"];
    if (share < row_.least_spawn_share)
        return fmt::format("spawn_share is {:.3f}, must be at least {:g}", share,
                           row_.least_spawn_share);
    const size_t reflectors = params_.value("reflectors", size_t{0});
    if (reflectors < row_.least_reflectors)
        return fmt::format("reflectors are {}, must be at least {}", reflectors,
                           row_.least_reflectors);
    return {};
}

bool RowRun::check(Frame& frame, json& metrics) const {
    const rsh_audit_report report = frame.audit(amount_.audit_tests);
    metrics.update({{"audited_rays", report.rays},
                    {"mismatches", report.differences},
                    {"bytes_peak", frame.scratch_bytes()}});
    return report.differences == 0;
}

// A frame of seconds is rendered once, and both times are its own.
void RowRun::time_frame(Frame& frame, size_t frame_number, size_t count, Times& times) {
    double upload_ms = 0;
    if (row_.scene.moves) {
        move_to((double(frame_number) + 0.5) / double(count));
        moment_->place_in(frame);
        upload_ms = moment_->upload();
    }
    let_threads_sleep();
    times.works.push_back(frame.count());
    times.ms.push_back(times.works.back().ms());
    const double counted_ms = times.works.back().frame_ms;
    times.frame_ms.push_back(upload_ms + (counted_ms > kSlowMs ? counted_ms : frame.render()));
}

Times RowRun::time(Frame& frame, size_t most) {
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    Times times;
    for (size_t i = 0; i < most; ++i) {
        if (i > 0 && run_.limit.has_passed()) break;
        if (i >= 3 && !row_.scene.moves && passed() > amount_.seconds) break;
        time_frame(frame, i, most, times);
        if (!row_.scene.moves && times.frame_ms.back() > kSlowMs) break;
    }
    return times;
}

void RowRun::measure(const std::string& engine) {
    Frame frame(run_.device, settings(engine));
    if (row_.scene.moves) move_to(0.5);
    moment_->place_in(frame);
    const std::string why = why_not(engine, frame);
    if (!why.empty()) return run_.results.leave_out(case_name(row_, engine), why);
    const auto start = std::chrono::steady_clock::now();
    json metrics = json::object();
    bool is_right = shortfall().empty();
    if (!is_right) metrics["error"] = shortfall();
    if (is_right) try {
            frame.allocate();
            is_right = check(frame, metrics);
            if (is_right) metrics.update(times_of(row_, time(frame, frames(engine))));
        } catch (const std::exception& error) {
            is_right = false;
            metrics["error"] = describe_error(error);
        }
    estimate_.add(
        engine, work(),
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    json params = params_;
    params["engine"] = engine;
    const Case done = {case_name(row_, engine), params, metrics, is_right};
    fmt::print("{}", as_text(done));
    run_.results.add(done);
}

}  // namespace

void measure_row(const Run& run, Estimate& estimate, const Row& row,
                 const std::vector<std::string>& engines, const Amount& amount) {
    RowRun row_run(run, estimate, row, amount);
    for (const std::string& engine : engines) row_run.measure(engine);
}

}  // namespace bench::paper
