#include "paper/measure.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "paper/moment.hpp"
#include "paper/paper_text.hpp"
#include "paper/scenes/reflectors.hpp"
#include "paper/times.hpp"
#include "timing.hpp"

namespace bench::paper {
namespace {

using nlohmann::json;

// Frames that take longer are rendered once.
constexpr double kSlowMs = 3000;

class RowRun {
public:
    RowRun(const Run& run, Estimate& estimate, const Row& row, MovingScene& scene,
           const Amount& amount)
        : run_(run), estimate_(estimate), row_(row), amount_(amount), scene_(scene) {
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
    }

    void measure(const std::string& engine);

private:
    void move_to(double fraction) {
        moment_.reset();
        moment_ = std::make_unique<Moment>(run_.device, scene_.at(fraction), row_);
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
    bool check(Frame& frame, json& metrics);
    void time_frame(Frame& frame, size_t frame_number, size_t count, Times& times);
    Times time(Frame& frame, size_t most);
    bool check_and_time(const std::string& engine, Frame& frame, json& metrics);

    const Run& run_;
    Estimate& estimate_;
    const Row& row_;
    const Amount& amount_;
    MovingScene& scene_;
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

// What the row's stand-in is like, by a frame of the quickest engine; the same for all of them.
void RowRun::look() {
    if (params_.contains("spawn_share")) return;
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

// What moves is checked at three moments.
bool RowRun::check(Frame& frame, json& metrics) {
    cl_ulong rays = 0, differences = 0;
    for (const double fraction : {0.1, 0.5, 0.9}) {
        if (row_.scene.moves) {
            move_to(fraction);
            moment_->place_in(frame);
        }
        const rsh_audit_report report = frame.audit(amount_.audit_tests);
        rays += report.rays;
        differences += report.differences;
        if (!row_.scene.moves) break;
    }
    metrics.update({{"audited_rays", rays},
                    {"mismatches", differences},
                    {"bytes_peak", frame.scratch_bytes()}});
    return differences == 0;
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

// Whether all was right; an error is among the metrics.
bool RowRun::check_and_time(const std::string& engine, Frame& frame, json& metrics) {
    try {
        look();
        const std::string lack = shortfall();
        if (!lack.empty()) throw std::runtime_error(lack);
        frame.allocate();
        if (!check(frame, metrics)) return false;
        metrics.update(times_of(row_, time(frame, frames(engine))));
    } catch (const std::exception& error) {
        metrics["error"] = describe_error(error);
    }
    return !metrics.contains("error");
}

void RowRun::measure(const std::string& engine) {
    Frame frame(run_.device, settings(engine));
    if (row_.scene.moves) move_to(0.5);
    moment_->place_in(frame);
    const std::string why = why_not(engine, frame);
    if (!why.empty()) return run_.results.leave_out(case_name(row_, engine), why);
    const auto start = std::chrono::steady_clock::now();
    json metrics = json::object();
    const bool is_right = check_and_time(engine, frame, metrics);
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

void measure_row(const Run& run, Estimate& estimate, const Row& row, MovingScene& scene,
                 const std::vector<std::string>& engines, const Amount& amount) {
    RowRun row_run(run, estimate, row, scene, amount);
    for (const std::string& engine : engines) row_run.measure(engine);
}

}  // namespace bench::paper
