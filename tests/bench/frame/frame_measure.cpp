// frame_measure.cpp - contenders, rounds, and medians into cases.
#include "frame/frame_measure.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <utility>

#include "frame/frame_contender.hpp"
#include "frame/frame_text.hpp"
#include "timing.hpp"

namespace bench {
namespace {

class RowRun {
public:
    RowRun(FrameRun& run, SceneOnDevice& scene, const FrameRow& row)
        : run_(run),
          device_(run.run.device),
          limit_(run.run.limit),
          results_(run.run.results),
          scene_(scene),
          row_(row),
          is_shadow_(row.rays == RayKind::kShadow) {}

    // Leaves out the columns that would take too long or too much; false: no column is left.
    bool choose(const std::vector<Column>& columns);
    bool make_rays();  // false: there is none
    void check();
    void time();
    void hand_in();

private:
    std::string why_not(const RshTracer& tracer) const;
    void try_to_check(FrameContender& contender);
    void compare_all();
    void time_round(double moment);
    nlohmann::json params(const FrameContender& contender) const;
    void leave_out(const Column& column, const std::string& why) {
        results_.leave_out(case_name(row_, column), why);
    }
    double work() const {
        return double(row_.size.pixels()) + scene_.geometry().triangle_count;
    }

    FrameRun& run_;
    const Device& device_;
    const Limit& limit_;
    Results& results_;
    SceneOnDevice& scene_;
    const FrameRow& row_;
    bool is_shadow_;
    std::unique_ptr<RayMaker> rays_;
    size_t active_rays_ = 0;
    std::vector<NamedBytes> needs_;  // of the row until now
    FramePeers peers_;
    std::vector<FrameContender> contenders_;
};

constexpr double kFewestFrames = 3;  // one is checked, one counted, one timed

// Shuffled rays are a list.
Size shape_of(const FrameRow& row) {
    if (row.rays != RayKind::kShuffled) return row.size;
    return {static_cast<cl_uint>(row.size.pixels()), 1};
}

bool RowRun::choose(const std::vector<Column>& columns) {
    needs_ = RayMaker::needs(row_.size);
    for (const Column& column : columns) {
        std::string why = run_.estimate.refusal(limit_, column.name(), work());
        auto tracer = std::make_unique<RshTracer>(
            run_.devices.at(column.vector_width), scene_.geometry(), shape_of(row_),
            is_shadow_ ? RSH_QUERY_ANY : RSH_QUERY_CLOSEST, column);
        if (why.empty()) why = why_not(*tracer);
        if (!why.empty()) {
            leave_out(column, why);
            continue;
        }
        for (const NamedBytes& need : tracer->needs()) needs_.push_back(need);
        contenders_.emplace_back();
        contenders_.back().column = column;
        contenders_.back().tracer = std::move(tracer);
    }
    return !contenders_.empty();
}

// All columns of a row are there at once. On the host: rays, and one column's hits.
std::string RowRun::why_not(const RshTracer& tracer) const {
    std::vector<NamedBytes> all = needs_;
    for (const NamedBytes& need : tracer.needs()) all.push_back(need);
    return memory_refusal(device_.memory(), all,
                          row_.size.pixels() * (sizeof(rsh_ray) + sizeof(rsh_hit)));
}

bool RowRun::make_rays() {
    scene_.move(kCheckedMoment);
    rays_ = std::make_unique<RayMaker>(device_, row_.size);
    rays_->make(scene_, row_.rays);
    active_rays_ = rays_->active_count();
    if (active_rays_ > 0) peers_ = make_frame_peers(device_, scene_, *rays_, is_shadow_);
    return active_rays_ > 0;
}

void RowRun::check() {
    for (const auto& peer : peers_) peer->answer();
    for (FrameContender& contender : contenders_) {
        if (limit_.has_passed())
            contender.why_left_out = limit_.when_passed();
        else
            try_to_check(contender);
    }
    compare_all();
}

// An error of one column says nothing about the others.
void RowRun::try_to_check(FrameContender& contender) {
    try {
        contender.check(scene_, *rays_, is_shadow_, peers_);
        if (!contender.is_wrong && limit_.has_passed())
            contender.why_left_out = limit_.when_passed() + " before it was timed; it is right";
        if (!contender.is_done()) contender.count(*rays_, active_rays_);
    } catch (const std::exception& error) {
        contender.is_wrong = true;
        contender.metrics["error"] = describe_error(error);
    }
}

// The hits of a row are the same bits in every column. Of columns that the sample found right and
// that differ all the same, nobody knows which one is wrong.
void RowRun::compare_all() {
    std::set<std::string> found;
    for (const FrameContender& contender : contenders_)
        if (!contender.is_wrong && !contender.hits_checksum.empty())
            found.insert(contender.hits_checksum);
    if (found.size() < 2) return;
    for (FrameContender& contender : contenders_) {
        if (contender.is_wrong) continue;
        contender.is_wrong = true;
        contender.metrics["columns_disagree"] = true;
    }
}

void RowRun::time_round(double moment) {
    scene_.move(moment);
    rays_->make(scene_, row_.rays);
    for (FrameContender& contender : contenders_) {
        if (contender.is_done()) continue;
        let_threads_sleep();
        contender.time(*rays_);
    }
    for (const auto& peer : peers_) peer->time_round();
}

void RowRun::time() {
    constexpr size_t kMostRounds = 25;
    const RowSettings& settings = run_.settings;
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (size_t round = 0; round < kMostRounds; ++round) {
        const bool is_done = std::all_of(contenders_.begin(), contenders_.end(),
                                         [](const FrameContender& c) { return c.is_done(); });
        if (is_done || (round >= settings.min_rounds && passed() > settings.seconds)) break;
        if (round > 0 && limit_.has_passed()) break;
        time_round(0.3 + 0.618 * double(round));
    }
}

nlohmann::json RowRun::params(const FrameContender& contender) const {
    return {{"scene", row_.scene.name},
            {"triangles", scene_.geometry().triangle_count},
            {"width", row_.size.width},
            {"height", row_.size.height},
            {"rays", name_of(row_.rays)},
            {"active_rays", active_rays_},
            {"engine", contender.column.engine_name},
            {"bound", contender.column.bound_name},
            {"refit", contender.column.is_refit},
            {"vector_width", contender.column.vector_width}};
}

void RowRun::hand_in() {
    for (FrameContender& contender : contenders_) {
        if (!contender.is_wrong && !contender.why_left_out.empty()) {
            leave_out(contender.column, contender.why_left_out);
            continue;
        }
        if (!contender.is_wrong)
            run_.estimate.add(contender.column.name(), work(),
                              1e-3 * kFewestFrames * contender.put_times(peers_));
        const Case done = {case_name(row_, contender.column), params(contender),
                           contender.metrics, !contender.is_wrong};
        print_frame(done);
        results_.add(done);
    }
}

}  // namespace

void measure_row(FrameRun& run, SceneOnDevice& scene, const FrameRow& row,
                 const std::vector<Column>& columns) {
    const bool lacks_light =
        row.rays == RayKind::kShadow && scene.frame_scene().point_light() < 0;
    RowRun row_run(run, scene, row);
    if (!lacks_light && !row_run.choose(columns)) return;
    if (lacks_light || !row_run.make_rays()) {
        for (const Column& column : columns)
            run.run.results.leave_out(case_name(row, column), "the scene has no such rays");
        return;
    }
    row_run.check();
    row_run.time();
    row_run.hand_in();
}

}  // namespace bench
