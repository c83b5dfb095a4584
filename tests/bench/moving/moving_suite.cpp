#include "moving/moving_suite.hpp"

#include <fmt/format.h>

#include "moving/many_frames.hpp"
#include "moving/object_in_room.hpp"
#include "progress.hpp"

namespace bench {
namespace {

using namespace moving;

constexpr ObjectInRoom kObject = {700000, 5000, {512, 512}, 41};
constexpr ObjectInRoom kQuickObject = {700000, 5000, {512, 512}, 11};
constexpr ManyFrames kFrames = {80000, {512, 512}, 300};
constexpr ManyFrames kQuickFrames = {80000, {128, 128}, 60};

template <class One>
void measure_one(const Run& run, const One& one, ProgressBar& progress) {
    progress.begin(one.case_name());
    if (run.limit.has_passed())
        return run.results.leave_out(one.case_name(), run.limit.when_passed());
    try {
        const Case done = measure(run.device, one);
        fmt::print("{}: {}\n", done.name, as_text(one, done));
        run.results.add(done);
    } catch (const std::exception& error) {
        run.results.add(
            {one.case_name(), one.params(), {{"error", describe_error(error)}}, false});
    }
}

}  // namespace

void MovingSuite::run(const Run& run) {
    ProgressBar progress(2);
    measure_one(run, run.quick ? kQuickObject : kObject, progress);
    measure_one(run, run.quick ? kQuickFrames : kFrames, progress);
}

}  // namespace bench
