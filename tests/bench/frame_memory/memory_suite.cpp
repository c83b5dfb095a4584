// memory_suite.cpp - chooses scenes and sizes; on each, every engine renders frames and traces rays.
#include "frame_memory/memory_suite.hpp"

#include <fmt/format.h>

#include <regex>

#include "frame/scene_shelf.hpp"
#include "frame_memory/device_bytes.hpp"
#include "frame_memory/measure.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace memory;

constexpr cl_uint kBounces = 2;

// Of --quick: within 20 s on two cores, once the programs are compiled. Streams of pairs may be given
// much less than they take: larger steps.
struct Plan {
    Amount amount;
    size_t frame_factor, trace_factor;  // from budget to budget
};
constexpr Plan kQuick = {{0.2, 3}, 4, 32}, kUsual = {{8, 15}, 2, 4};

const Plan& plan_of(bool quick) {
    return quick ? kQuick : kUsual;
}

struct Row {
    SceneSpec scene;
    Size size;
    bool is_quick = false;
};

SceneSpec room(const char* name, Reflector reflector, int64_t triangles) {
    return {name, reflector, triangles, "", false};
}

SceneSpec file(const std::string& name) {
    return {name, Reflector::kFile, 0, RSH_SCENE_FILES "/" + name + ".json", false};
}

const std::vector<Row>& rows() {
    static const std::vector<Row> all = {
        {room("room-several-10k", Reflector::kSeveral, 10000), {128, 192}, true},
        {room("room-several-20k", Reflector::kSeveral, 20000), {512, 512}},
        {room("room-glass-80k", Reflector::kGlass, 80000), {256, 256}},
        {room("room-floor-700k", Reflector::kFloor, 700000), {256, 256}},
        {file("cornell_mirror"), {256, 256}},
        {file("chinese_dragon_20k"), {256, 256}},
        {file("kitchen"), {128, 128}},
    };
    return all;
}

// A call on a scene with one engine: budgets are cases of it.
struct Work {
    const Row* row;
    std::string call, engine;

    Subject subject() const {
        const Plan& plan = plan_of(row->is_quick);
        return {call,
                row->scene.name,
                engine,
                row->size,
                {{"bounces", call == "frame" ? kBounces : 1}},
                call == "frame" ? plan.frame_factor : plan.trace_factor};
    }
    bool has_expected_of(const Work& other) const {
        return row == other.row && call == other.call;
    }
};

// Row by row, call by call. The engine tiles has no streams: only its frames take a budget.
std::vector<Work> select(bool quick, const std::string& filter) {
    const std::regex wanted(filter.empty() ? "." : filter);
    std::vector<Work> selected;
    for (const Row& row : rows())
        for (const char* call : {"frame", "trace"})
            for (const char* engine : {"tiles", "paper", "paper_faithful"}) {
                const Work work = {&row, call, engine};
                const bool has_budget = work.call == "frame" || work.engine != "tiles";
                if (has_budget && row.is_quick == quick &&
                    std::regex_search(work.subject().case_name(""), wanted))
                    selected.push_back(work);
            }
    return selected;
}

class MemoryRun {
public:
    explicit MemoryRun(const Run& run)
        : run_(run), amount_(plan_of(run.quick).amount), shelf_(run.device) {}

    void start(const Work& work);

private:
    void measure_on(SceneOnDevice& scene, const Work& work);
    std::unique_ptr<BudgetedCall> make_call(const SceneOnDevice& scene, const Work& work);

    const Run& run_;
    const Amount amount_;
    SceneShelf shelf_;
    std::unique_ptr<RayMaker> rays_;  // of the last call of rsh_trace
    Work last_ = {};
    Expected expected_;
};

// A scene whose files are missing is left out; all else that fails is wrong.
void MemoryRun::start(const Work& work) {
    std::string why = run_.limit.has_passed() ? run_.limit.when_passed() : "";
    SceneOnDevice* scene = nullptr;
    try {
        if (why.empty()) scene = &shelf_.get(work.row->scene);
    } catch (const std::exception& error) {
        why = describe_error(error);
    }
    const std::string name = work.subject().case_name("all");
    if (!scene) return run_.results.leave_out(name, why);
    try {
        measure_on(*scene, work);
    } catch (const std::exception& error) {
        fmt::print("{}: {}\n", name, describe_error(error));
        run_.results.add({name,
                          {{"scene", work.row->scene.name}, {"engine", work.engine}},
                          {{"error", describe_error(error)}},
                          false});
    }
}

void MemoryRun::measure_on(SceneOnDevice& scene, const Work& work) {
    if (!work.has_expected_of(last_)) expected_.clear();
    last_ = work;
    Subject subject = work.subject();
    subject.params["triangles"] = scene.geometry().triangle_count;
    const auto call = make_call(scene, work);
    measure(run_, subject, *call, amount_, expected_);
}

std::unique_ptr<BudgetedCall> MemoryRun::make_call(const SceneOnDevice& scene,
                                                   const Work& work) {
    cl_uint engine = 0;
    rsh::check(rsh_engine_from_name(work.engine.c_str(), &engine), "rsh_engine_from_name");
    if (work.call == "frame")
        return make_frame_call(run_.device, scene, work.row->size, kBounces, engine);
    rays_ = std::make_unique<RayMaker>(run_.device, work.row->size);
    rays_->make(scene, RayKind::kReflection);
    return make_trace_call(run_.device, scene, *rays_, engine);
}

}  // namespace

void MemorySuite::add_options(CLI::App& app) {
    app.add_option("--filter", filter_,
                   "Only cases whose name, up to the budget, has a match of this expression");
    app.add_flag("--list", lists_, "Print the names of the cases instead of running them");
}

void MemorySuite::prepare() {
    load_counting_layer();
}

void MemorySuite::run(const Run& run) {
    const std::vector<Work> selected = select(run.quick, filter_);
    if (lists_) {
        for (const Work& work : selected) fmt::print("{}\n", work.subject().case_name("..."));
        return;
    }
    MemoryRun memory_run(run);
    ProgressBar progress(selected.size());
    for (const Work& work : selected) {
        progress.begin(work.subject().case_name(""));
        memory_run.start(work);
    }
}

}  // namespace bench
