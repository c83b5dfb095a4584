#include "accuracy/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>

#include "accuracy/accuracy_text.hpp"
#include "accuracy/picture_errors.hpp"
#include "accuracy/references.hpp"
#include "accuracy/scene_on_device.hpp"
#include "hits/errors.hpp"
#include "timing.hpp"

namespace bench::accuracy {
namespace {

struct Entry {
    const Point& point;
    Setting setting;
    cl_uint width, height;
    std::unique_ptr<FrameOnDevice> frame = nullptr;
    nlohmann::json metrics = nlohmann::json::object();
    std::string why_left_out = {};
    bool is_wrong = false;
    std::vector<double> ms = {};

    // A wrong picture has no speed; what is slow tells all there is to tell after one.
    bool is_done() const {
        constexpr double kSlowMs = 500;
        return !frame || is_wrong || (!ms.empty() && ms.back() > kSlowMs);
    }
};

// Pixels that are not the same bits, of two pictures of one size.
size_t count_differing(const std::vector<cl_float4>& a, const std::vector<cl_float4>& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) count += std::memcmp(&a[i], &b[i], sizeof a[i]) != 0;
    return count;
}

// Of the nodes over the rays.
std::string shape_of(cl_uint engine) {
    const cl_uint shape = rsh_engine_shape(engine);
    return shape == RSH_SHAPE_DEFAULT ? "none" : rsh_shape_name(shape);
}

class SceneRun {
public:
    SceneRun(const Run& run, const SceneKind& kind, const Staged& staged, const Amount& amount)
        : run_(run),
          kind_(kind),
          amount_(amount),
          staged_(staged),
          references_(make_references(staged_, amount.width, amount.height)),
          truth_(references_.truth),
          centres_(references_.centres),
          on_device_(run.device, staged_) {
        write_picture("truth", references_.truth);
        write_picture("centres", references_.centres);
    }

    void check(const std::vector<Point>& points);
    void time();
    void hand_in();

private:
    std::string why_not(const Entry& entry) const;
    void check(Entry& entry);
    void compare_picture(const Image& image, Entry& entry) const;
    Image in_base_size(const Image& image) const;
    const hits::Errors& first_wave(cl_uint width, cl_uint height);
    std::string write_picture(const std::string& name, const Image& image) const;
    nlohmann::json params_of(const Entry& entry) const;
    void put_times(Entry& entry) const;

    const Run& run_;
    const SceneKind& kind_;
    const Amount& amount_;
    const Staged& staged_;
    const References references_;
    const Shown truth_, centres_;
    const SceneOnDevice on_device_;
    std::vector<cl_float4> default_pixels_;
    std::map<cl_uint, hits::Errors> first_waves_;  // by width
    std::vector<Entry> entries_;
};

std::string SceneRun::why_not(const Entry& entry) const {
    if (run_.limit.has_passed()) return run_.limit.when_passed();
    const Setting& setting = entry.setting;
    if ((setting.without & on_device_.features()) != setting.without)
        return "the scene has no " + entry.point.axis;
    const double pairs =
        double(entry.width) * entry.height * staged_.scene.mesh.triangle_count();
    if (setting.engine == RSH_ENGINE_BRUTE_FORCE && pairs > amount_.pairs)
        return fmt::format("{:.2g} pairs of a pixel and a triangle, at most {:.2g}", pairs,
                           amount_.pairs);
    return {};
}

void SceneRun::check(const std::vector<Point>& points) {
    for (const Point& point : points) {
        const Setting setting = point.setting();
        entries_.push_back({point, setting, cl_uint(setting.size * amount_.width),
                            cl_uint(setting.size * amount_.height)});
        Entry& entry = entries_.back();
        entry.why_left_out = why_not(entry);
        if (!entry.why_left_out.empty()) continue;
        try {
            check(entry);
        } catch (const std::exception& error) {
            entry.is_wrong = true;
            entry.metrics["error"] = describe_error(error);
        }
    }
}

void SceneRun::check(Entry& entry) {
    entry.frame =
        std::make_unique<FrameOnDevice>(on_device_, entry.width, entry.height, entry.setting);
    entry.frame->render();
    const std::vector<cl_float4> pixels = entry.frame->pixels();
    if (default_pixels_.empty()) default_pixels_ = pixels;
    if (entry.point.is_exact) {
        const size_t differ = count_differing(pixels, default_pixels_);
        entry.metrics["differ"] = differ;
        entry.is_wrong = differ > 0;
    }
    const hits::Errors& errors = first_wave(entry.width, entry.height);
    errors.put(entry.metrics);
    entry.is_wrong |= errors.all() > 0;
    compare_picture(in_base_size(image_of(pixels, entry.width, entry.height)), entry);
}

void SceneRun::compare_picture(const Image& image, Entry& entry) const {
    const Shown shown(image);
    compare(truth_, shown, references_.is_edge).put(entry.metrics, "");
    compare(centres_, shown, references_.is_edge).put(entry.metrics, "_centres");
    if (&entry == &entries_.front()) entry.metrics["reference_cut"] = references_.cut_pixels;
    std::string name = entry.point.axis + "_" + entry.point.value;
    std::replace(name.begin(), name.end(), '/', '_');
    const std::string file = write_picture(name, image);
    if (!file.empty()) entry.metrics["picture"] = file;
}

Image SceneRun::in_base_size(const Image& image) const {
    if (image.width > amount_.width) return averaged(image, image.width / amount_.width);
    if (image.width < amount_.width) return interpolated(image, amount_.width, amount_.height);
    return image;
}

// The hits of rsh_rasterize, which begin every frame of that size.
const hits::Errors& SceneRun::first_wave(cl_uint width, cl_uint height) {
    const auto known = first_waves_.find(width);
    if (known != first_waves_.end()) return known->second;
    std::vector<rsh_hit> found;
    stability::Scene scene;
    scene.mesh = staged_.scene.mesh;
    scene.rays = {on_device_.first_rays(width, height, &found), width, height};
    const size_t judged = size_t(amount_.decisions / scene.mesh.triangle_count());
    const stability::Expected expected =
        stability::expected_answers(scene, stability::Kind::kAimed, judged);
    return first_waves_[width] = hits::count_errors(scene, expected, false, found);
}

// Its name in the folder; empty: none is written.
std::string SceneRun::write_picture(const std::string& name, const Image& image) const {
    if (amount_.pictures.empty()) return {};
    const std::string file = kind_.name + "-" + name + ".ppm";
    accuracy::write_picture(amount_.pictures + "/" + file, image);
    return file;
}

void SceneRun::time() {
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    constexpr size_t kLeastRounds = 3;
    for (size_t round = 0; round < amount_.rounds; ++round) {
        if (round >= kLeastRounds && passed() > amount_.seconds) break;
        if (round > 0 && run_.limit.has_passed()) break;
        for (Entry& entry : entries_) {
            if (entry.is_done()) continue;
            let_threads_sleep();
            entry.ms.push_back(entry.frame->render());
        }
    }
}

// ratio: the default's time over this one's in the same round; above 1, this is quicker. ms: the
// default's median over that, so that whatever slows the machine down for a while slows both.
void SceneRun::put_times(Entry& entry) const {
    const std::vector<double>& base = entries_.front().ms;
    std::vector<double> ratios;
    for (size_t i = 0; i < std::min(entry.ms.size(), base.size()); ++i)
        ratios.push_back(base[i] / entry.ms[i]);
    const double base_ms = spread(base).median;
    const Spread ratio = spread(ratios);
    entry.metrics.update({{"ms", base_ms / ratio.median},
                          {"ms_low", base_ms / ratio.high},
                          {"ms_high", base_ms / ratio.low},
                          {"ratio", ratio.median},
                          {"rounds", entry.ms.size()}});
}

nlohmann::json SceneRun::params_of(const Entry& entry) const {
    const Setting& setting = entry.setting;
    return {{"scene", kind_.name},
            {"axis", entry.point.axis},
            {"value", entry.point.value},
            {"engine", rsh_engine_name(setting.engine)},
            {"shape", shape_of(setting.engine)},
            {"bounces", setting.bounces},
            {"min_weight", setting.min_weight},
            {"samples", setting.size * setting.size},
            {"width", amount_.width},
            {"height", amount_.height},
            {"triangles", staged_.scene.mesh.triangle_count()}};
}

void SceneRun::hand_in() {
    for (Entry& entry : entries_) {
        const std::string name = case_name(kind_, entry.point);
        if (!entry.why_left_out.empty()) {
            run_.results.leave_out(name, entry.why_left_out);
            continue;
        }
        if (!entry.is_wrong) put_times(entry);
        const Case done = {name, params_of(entry), entry.metrics, !entry.is_wrong};
        fmt::print("{}", as_text(done));
        run_.results.add(done);
    }
}

}  // namespace

std::string case_name(const SceneKind& scene, const Point& point) {
    return fmt::format("accuracy/scene:{}/axis:{}/value:{}", scene.name, point.axis,
                       point.value);
}

void measure_scene(const Run& run, const SceneKind& kind, const Staged& staged,
                   const std::vector<Point>& points, const Amount& amount) {
    SceneRun scene(run, kind, staged, amount);
    scene.check(points);
    scene.time();
    scene.hand_in();
}

}  // namespace bench::accuracy
