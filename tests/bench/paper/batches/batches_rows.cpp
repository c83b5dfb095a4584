#include "paper/batches/batches_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "paper/batches/sources.hpp"
#include "paper/moment.hpp"
#include "paper/paper_text.hpp"
#include "paper/process_memory.hpp"
#include "paper/times.hpp"

namespace bench::paper {
namespace {

using nlohmann::json;

constexpr const char* kEngine = "tiles";
constexpr cl_uint kBatches[] = {1, 2, 4, 8, 16, 32, 64};
constexpr cl_uint kBatchesOfPaper = 50;
constexpr cl_uint kCopies = 1001;
constexpr size_t kOutOfCoreBudget = size_t{256} << 20;
constexpr cl_uint kOtherBatch = 100000;  // triangles, of the second way to cut the scene
constexpr size_t kOutOfCoreFrames = 3;

Row row_named(const std::string& name, int64_t triangles = 0) {
    for (const Row& row : rows())
        if (row.name == name && (triangles == 0 || row.scene.triangles == triangles))
            return row;
    throw std::logic_error("rsh-bench paper has no row " + name);
}

std::string name_of(const char* row, const std::string& series) {
    return fmt::format("paper/row:{}{}/size:512x512/engine:{}", row, series, kEngine);
}

std::string batches_name(cl_uint batches) {
    return name_of("batches", fmt::format("/batches:{}", batches));
}
std::string large_name() {
    return name_of("large_batches", fmt::format("/batches:{}", kBatchesOfPaper));
}
std::string out_of_core_name() {
    return name_of("out_of_core", "");
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

FrameSettings settings_of(const Row& row) {
    FrameSettings settings = {row.size, row.bounces};
    settings.engine = RSH_ENGINE_TILES;
    return settings;
}

size_t count_differing(const std::vector<cl_float4>& a, const std::vector<cl_float4>& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) count += std::memcmp(&a[i], &b[i], sizeof a[i]) != 0;
    return count;
}

Times time_frames(Frame& frame, size_t count, const Limit& limit) {
    Times times;
    for (size_t i = 0; i < count && (i == 0 || !limit.has_passed()); ++i) {
        times.works.push_back(frame.count());
        times.ms.push_back(times.works.back().ms());
        times.frame_ms.push_back(frame.render());
    }
    return times;
}

void add_times(const Row& row, const Times& times, Case& done) {
    const double rays = double(times.works.front().statistics.active_rays[1]);
    done.params["spawn_share"] = rays / double(row.size.pixels());
    done.metrics.update(times_of(row, times));
}

json params_of(const Row& row, size_t triangles, cl_uint batches) {
    return {{"row", row.name},
            {"scene", row.scene.name},
            {"triangles", triangles},
            {"width", row.size.width},
            {"height", row.size.height},
            {"bounces", row.bounces},
            {"shadows", row.has_shadows},
            {"engine", kEngine},
            {"batches", batches}};
}

// Measures a case, unless the time is up; one whose call fails is wrong.
template <class Measure>
void attempt(const Run& run, Case done, Measure measure) {
    if (run.limit.has_passed())
        return run.results.leave_out(done.name, run.limit.when_passed());
    try {
        measure(done);
    } catch (const std::exception& error) {
        done.metrics["error"] = describe_error(error);
        done.ok = false;
    }
    fmt::print("{}", as_text(done));
    run.results.add(done);
}

// A scene, or nothing where its files are missing: these cases are left out then.
template <class Open>
std::optional<StillScene> opened(const Run& run, const std::vector<std::string>& names,
                                 Open open) {
    try {
        return open();
    } catch (const std::exception& error) {
        for (const std::string& name : names)
            run.results.leave_out(name, describe_error(error));
        return {};
    }
}

// A row's scene, whole and in any number of batches.
class Batched {
public:
    Batched(const Run& run, Row row, StillScene scene)
        : run_(run), row_(std::move(row)), moment_(run.device, std::move(scene), row_) {}

    void measure(const std::string& name, cl_uint batches, size_t frames) {
        const size_t triangles = moment_.still().mesh.triangles.size();
        attempt(run_, {name, params_of(row_, triangles, batches), json::object(), true},
                [&](Case& done) { check_and_time(done, batches, frames); });
    }

private:
    void check_and_time(Case& done, cl_uint batches, size_t frames) {
        if (expected_.empty()) expected_ = whole();
        const render::Mesh& mesh = moment_.still().mesh;
        const cl_uint triangles = static_cast<cl_uint>(mesh.triangles.size());
        const MeshSource source(mesh, (triangles + batches - 1) / batches);
        Frame frame(run_.device, settings_of(row_));
        moment_.place_in(frame);
        frame.take_batches(source.get());
        frame.allocate();
        frame.render();
        const size_t mismatches = count_differing(frame.pixels(), expected_);
        done.ok = mismatches == 0;
        done.metrics = {{"mismatches", mismatches}, {"bytes_peak", frame.scratch_bytes()}};
        if (done.ok) add_times(row_, time_frames(frame, frames, run_.limit), done);
    }

    std::vector<cl_float4> whole() const {
        Frame frame(run_.device, settings_of(row_));
        moment_.place_in(frame);
        frame.allocate();
        frame.render();
        return frame.pixels();
    }

    const Run& run_;
    const Row row_;
    const Moment moment_;
    std::vector<cl_float4> expected_;
};

Row out_of_core_row() {
    Row row = {"out_of_core", row_named("one_reflector").scene};
    row.scene.name = "a dragon, 1001 times";
    row.has_shadows = true;
    return row;
}

// The mesh that was added last.
render::Mesh last_mesh(const render::Mesh& mesh) {
    constexpr uint32_t kNew = ~0u;
    std::vector<uint32_t> numbers(mesh.positions.size(), kNew);
    render::Mesh last;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (mesh.material_ids[i] != mesh.material_ids.back()) continue;
        glm::uvec3 triangle = mesh.triangles[i];
        for (int k = 0; k < 3; ++k) {
            uint32_t& number = numbers[triangle[k]];
            if (number == kNew) {
                number = uint32_t(last.positions.size());
                last.positions.push_back(mesh.positions[triangle[k]]);
            }
            triangle[k] = number;
        }
        last.triangles.push_back(triangle);
        last.material_ids.push_back(0);
    }
    return last;
}

// A dragon that reflects a little, a light from afar, and a camera that sees many copies.
StillScene repeated_scene() {
    SceneKind kind = {};
    kind.source = Source::kFile;
    kind.file = RSH_SCENE_FILES "/chinese_dragon_20k.json";
    StillScene scene = open_scene(kind)->at(0);
    scene.mesh = last_mesh(scene.mesh);
    scene.materials = {scene.materials.back()};
    scene.materials[0].reflection = {{0.3f, 0.3f, 0.3f, 0}};
    scene.lights.assign(1, {});
    scene.lights[0].kind = RSH_LIGHT_DIRECTIONAL;
    scene.lights[0].direction = {0.5f, -0.7f, -0.5f};
    scene.camera.eye = {0.0f, 6.0f, 4.0f};
    scene.camera.at = {0.0f, 2.5f, -5.5f};
    scene.camera.vertical_degrees = 53;
    return scene;
}

// The picture of the copies, in batches of at most so many triangles; `use` sees the frame as well.
template <class Use>
std::vector<cl_float4> picture_of_copies(const Run& run, const Row& row, const Moment& moment,
                                         cl_uint most, Use use) {
    const RepeatedSource source(moment.still().mesh, kCopies, most);
    FrameSettings settings = settings_of(row);
    settings.budget = kOutOfCoreBudget;
    Frame frame(run.device, settings);
    moment.place_in(frame);
    frame.take_batches(source.get());
    frame.allocate();
    frame.render();
    const std::vector<cl_float4> pixels = frame.pixels();
    use(frame);
    return pixels;
}

// Against the same copies, cut in another way.
void check_and_time_repeated(const Run& run, const Row& row, const Moment& moment, Case& done) {
    const auto expected = picture_of_copies(run, row, moment, kOtherBatch, [](const Frame&) {});
    const auto actual = picture_of_copies(run, row, moment, 0, [&](Frame& frame) {
        add_times(row, time_frames(frame, kOutOfCoreFrames, run.limit), done);
        done.metrics["bytes_peak"] = frame.scratch_bytes();
    });
    const size_t mismatches = count_differing(actual, expected);
    done.ok = mismatches == 0;
    done.metrics.update({{"mismatches", mismatches}, {"process_bytes", process_peak_bytes()}});
}

}  // namespace

std::vector<std::string> batches_case_names(bool quick) {
    std::vector<std::string> names;
    for (const cl_uint batches : kBatches)
        if (!quick) names.push_back(batches_name(batches));
    names.push_back(large_name());
    if (!quick) names.push_back(out_of_core_name());
    return names;
}

void measure_batches(const Run& run, const std::vector<std::string>& names,
                     const Amount& amount) {
    std::vector<std::string> asked;
    for (const cl_uint batches : kBatches)
        if (has(names, batches_name(batches))) asked.push_back(batches_name(batches));
    const auto measure = [&](const char* name, const Row& of, const auto& cases) {
        Row row = of;
        row.name = name;
        auto scene = opened(run, asked, [&] { return open_scene(row.scene)->at(0.5); });
        if (!scene) return;
        Batched batched(run, row, std::move(*scene));
        cases(batched);
    };
    if (!asked.empty()) {
        Row row = row_named("patio", 700000);
        row.paper_ms.reset();
        measure("batches", row, [&](Batched& scene) {
            for (const cl_uint batches : kBatches)
                if (has(asked, batches_name(batches)))
                    scene.measure(batches_name(batches), batches, amount.slow_frames);
        });
    }
    asked = {large_name()};
    if (!has(names, large_name())) return;
    measure("large_batches", row_named("large"), [&](Batched& scene) {
        scene.measure(large_name(), kBatchesOfPaper, amount.slow_frames);
    });
}

void measure_out_of_core(const Run& run, const std::vector<std::string>& names) {
    if (!has(names, out_of_core_name())) return;
    auto scene = opened(run, {out_of_core_name()}, repeated_scene);
    if (!scene) return;
    const Row row = out_of_core_row();
    const size_t triangles = kCopies * scene->mesh.triangles.size();
    const Moment moment(run.device, std::move(*scene), row);
    Case done = {out_of_core_name(), params_of(row, triangles, 0), json::object(), true};
    done.params["budget"] = kOutOfCoreBudget;
    attempt(run, done, [&](Case& of) { check_and_time_repeated(run, row, moment, of); });
}

}  // namespace bench::paper
