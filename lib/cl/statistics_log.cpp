#include "cl/statistics_log.hpp"

namespace rsh {
namespace {

cl_ulong duration_ns(const cl::Event& event) {
    cl_ulong start = 0, end = 0;
    if (event.getInfo<CL_EVENT_COMMAND_QUEUE>()() == nullptr) return 0;
    // CL_PROFILING_INFO_NOT_AVAILABLE is no failure: the queue does not measure.
    if (clGetEventProfilingInfo(event(), CL_PROFILING_COMMAND_START, sizeof start, &start,
                                nullptr) != CL_SUCCESS ||
        clGetEventProfilingInfo(event(), CL_PROFILING_COMMAND_END, sizeof end, &end, nullptr) !=
            CL_SUCCESS)
        return 0;
    return end > start ? end - start : 0;
}

}  // namespace

void StatisticsLog::enable(bool enabled) {
    const std::lock_guard<std::mutex> lock(mutex_);
    settle();
    enabled_ = enabled;
    sums_ = {};
}

bool StatisticsLog::enabled() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return enabled_;
}

void StatisticsLog::add_command(cl_uint stage, const cl::Event& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (enabled_) commands_.push_back({stage, event});
}

void StatisticsLog::add(const std::function<void(rsh_statistics&)>& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (enabled_) change(sums_);
}

cl_uint* StatisticsLog::expect_counts(
    size_t count, std::function<void(rsh_statistics&, const cl_uint*)> use) {
    const std::lock_guard<std::mutex> lock(mutex_);
    pending_.push_back({std::vector<cl_uint>(count), std::move(use)});
    return pending_.back().counts.data();
}

void StatisticsLog::add_pending(const cl::Event& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reads_.push_back(event);
}

rsh_statistics StatisticsLog::sum() {
    const std::lock_guard<std::mutex> lock(mutex_);
    settle();
    return sums_;
}

// Waits for what was recorded and folds it into the sums, so that a long count stays small.
void StatisticsLog::settle() {
    for (const Command& command : commands_) {
        command.event.wait();
        sums_.stage_ns[command.stage] += duration_ns(command.event);
        ++sums_.launches;
    }
    for (const cl::Event& read : reads_) read.wait();
    for (const Pending& pending : pending_) pending.use(sums_, pending.counts.data());
    commands_.clear();
    reads_.clear();
    pending_.clear();
}

}  // namespace rsh
