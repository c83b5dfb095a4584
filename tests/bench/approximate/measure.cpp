#include "approximate/measure.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <ctime>
#include <memory>

#include "accuracy/picture_errors.hpp"
#include "approximate/approximate_text.hpp"
#include "timing.hpp"

namespace bench::approximate {
namespace {

using accuracy::FrameOnDevice;
using accuracy::Setting;
using accuracy::Shown;
using Pixels = std::vector<cl_float4>;

constexpr cl_uint kWidestStep = 4;  // rsh.h, rsh_frame: of pixels that are traced as ever

bool same(const cl_float4& a, const cl_float4& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

size_t count_differing(const Pixels& a, const Pixels& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) count += !same(a[i], b[i]);
    return count;
}

// Of the pixels that every approximate frame traces.
size_t count_differing_on_grid(const Pixels& a, const Pixels& b, size_t width) {
    size_t count = 0;
    for (size_t y = 0; y * width < a.size(); y += kWidestStep)
        for (size_t x = 0; x < width; x += kWidestStep)
            count += !same(a[y * width + x], b[y * width + x]);
    return count;
}

// Camera's rays that hit something, of the pixels that are traced.
double count_traced(rsh_context context, FrameOnDevice& frame) {
    rsh::check(rsh_count_statistics(context, CL_TRUE), "rsh_count_statistics");
    frame.render();
    rsh_statistics statistics = rsh::make<rsh_statistics>();
    rsh::check(rsh_get_statistics(context, &statistics), "rsh_get_statistics");
    rsh::check(rsh_count_statistics(context, CL_FALSE), "rsh_count_statistics");
    return double(statistics.active_rays[0]);
}

struct Entry {
    float tolerance;
    FrameOnDevice frame;
    nlohmann::json metrics = nlohmann::json::object();
    bool is_wrong = false;
    std::vector<double> ms = {}, cpu_ms = {};

    Entry(const accuracy::SceneOnDevice& scene, const Picture& picture, const Setting& setting)
        : tolerance(setting.tolerance),
          frame(scene, picture.width, picture.height(), setting) {}
};

void add_times(Entry& entry) {
    let_threads_sleep();
    const std::clock_t start = std::clock();
    entry.ms.push_back(entry.frame.render());
    entry.cpu_ms.push_back(1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC);
}

// Of the exact frame's time over the other one's in the same round; above 1, that one is quicker.
Spread ratio_of(const std::vector<double>& exact, const std::vector<double>& other) {
    std::vector<double> ratios;
    for (size_t i = 0; i < other.size(); ++i) ratios.push_back(exact[i] / other[i]);
    return spread(ratios);
}

class PictureRun {
public:
    PictureRun(const Run& run, const Picture& picture, const accuracy::Staged& staged,
               const accuracy::SceneOnDevice& scene)
        : run_(run), picture_(picture), staged_(staged), scene_(scene), exact_(make_entry(0)) {}

    void check();
    void time(const Amount& amount);
    void hand_in() const;

private:
    std::unique_ptr<Entry> make_entry(float tolerance) const;
    void check(Entry& entry, const Pixels& exact, const Shown& shown_exact, double hits) const;
    Shown shown(const Pixels& pixels) const;
    nlohmann::json times_of(const Entry& entry) const;
    nlohmann::json params_of(const Entry& entry) const;

    const Run& run_;
    const Picture& picture_;
    const accuracy::Staged& staged_;
    const accuracy::SceneOnDevice& scene_;
    std::unique_ptr<Entry> exact_;
    std::vector<std::unique_ptr<Entry>> entries_;
};

std::unique_ptr<Entry> PictureRun::make_entry(float tolerance) const {
    Setting setting;
    setting.bounces = staged_.bounces;
    setting.min_weight = staged_.min_weight;
    setting.tolerance = tolerance;
    return std::make_unique<Entry>(scene_, picture_, setting);
}

Shown PictureRun::shown(const Pixels& pixels) const {
    return Shown(accuracy::image_of(pixels, picture_.width, picture_.height()));
}

void PictureRun::check() {
    const double hits = count_traced(run_.device.rsh(), exact_->frame);
    const Pixels pixels = exact_->frame.pixels();
    const Shown exact = shown(pixels);
    for (const float tolerance : picture_.tolerances) {
        entries_.push_back(make_entry(tolerance));
        check(*entries_.back(), pixels, exact, hits);
    }
}

// hits: of the camera's rays, all of them.
void PictureRun::check(Entry& entry, const Pixels& exact, const Shown& shown_exact,
                       double hits) const {
    const double traced = count_traced(run_.device.rsh(), entry.frame);
    const Pixels pixels = entry.frame.pixels();
    entry.frame.render();
    const size_t differ = count_differing_on_grid(pixels, exact, picture_.width);
    const size_t unsteady = count_differing(pixels, entry.frame.pixels());
    entry.is_wrong = differ > 0 || unsteady > 0;
    const std::vector<bool> no_edges(pixels.size());
    const accuracy::PictureErrors errors =
        accuracy::compare(shown_exact, shown(pixels), no_edges);
    entry.metrics = {{"rmse", errors.rmse},
                     {"wrong_pixels", errors.wrong_pixels},
                     {"flip", errors.flip},
                     {"flip_above", errors.flip_above},
                     {"traced", hits > 0 ? traced / hits : 0},
                     {"differ", differ},
                     {"unsteady", unsteady}};
}

void PictureRun::time(const Amount& amount) {
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    constexpr size_t kLeastRounds = 5;
    for (size_t round = 0; round < amount.rounds; ++round) {
        if (round >= kLeastRounds && passed() > amount.seconds) break;
        if (round > 0 && run_.limit.has_passed()) break;
        add_times(*exact_);
        for (const auto& entry : entries_)
            if (!entry->is_wrong) add_times(*entry);
    }
}

nlohmann::json PictureRun::times_of(const Entry& entry) const {
    const Spread ms = spread(entry.ms), ratio = ratio_of(exact_->ms, entry.ms);
    return {{"ms", ms.median},
            {"ms_low", ms.low},
            {"ms_high", ms.high},
            {"exact_ms", spread(exact_->ms).median},
            {"ratio", ratio.median},
            {"ratio_low", ratio.low},
            {"ratio_high", ratio.high},
            {"ratio_cpu", ratio_of(exact_->cpu_ms, entry.cpu_ms).median},
            {"rounds", entry.ms.size()}};
}

nlohmann::json PictureRun::params_of(const Entry& entry) const {
    return {{"scene", picture_.scene},
            {"width", picture_.width},
            {"height", picture_.height()},
            {"tolerance", std::stod(fmt::format("{}", entry.tolerance))},
            {"bounces", staged_.bounces},
            {"min_weight", std::stod(fmt::format("{}", staged_.min_weight))},
            {"triangles", staged_.scene.mesh.triangle_count()}};
}

void PictureRun::hand_in() const {
    for (const auto& entry : entries_) {
        Case done = {picture_.case_name(entry->tolerance), params_of(*entry), entry->metrics,
                     !entry->is_wrong};
        if (done.ok) done.metrics.update(times_of(*entry));
        fmt::print("{}", as_text(done));
        run_.results.add(done);
    }
}

}  // namespace

std::string Picture::case_name(float tolerance) const {
    return fmt::format("approximate/scene:{}/width:{}/tolerance:{}", scene, width, tolerance);
}

void measure_picture(const Run& run, const Picture& picture, const accuracy::Staged& staged,
                     const accuracy::SceneOnDevice& scene, const Amount& amount) {
    PictureRun measured(run, picture, staged, scene);
    measured.check();
    measured.time(amount);
    measured.hand_in();
}

}  // namespace bench::approximate
