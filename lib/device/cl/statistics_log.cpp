#include "device/cl/statistics_log.hpp"

namespace rsh {
namespace {

// Of a command that failed, or cannot be waited for, less is told, and nothing else.
void wait_for(cl_event event) noexcept {
    if (event) opencl(event).clWaitForEvents(1, &event);
}

// CL_PROFILING_INFO_NOT_AVAILABLE is no failure: the queue does not measure, or the command
// failed.
cl_ulong duration_ns(cl_event event) {
    cl_ulong start = 0, end = 0;
    if (opencl(event).clGetEventProfilingInfo(event, CL_PROFILING_COMMAND_START, sizeof start,
                                              &start, nullptr) != CL_SUCCESS ||
        opencl(event).clGetEventProfilingInfo(event, CL_PROFILING_COMMAND_END, sizeof end, &end,
                                              nullptr) != CL_SUCCESS)
        return 0;
    return end > start ? end - start : 0;
}

}  // namespace

void StatisticsLog::Pending::wait() const noexcept {
    for (const Command& command : commands) wait_for(command.event.get());
    for (const CountRead& count : reads) wait_for(count.read.event());
}

void StatisticsLog::Pending::add_to(rsh_statistics& sums) const {
    for (const Command& command : commands) {
        sums.stage_ns[command.stage] += duration_ns(command.event.get());
        ++sums.launches;
    }
    for (const CountRead& count : reads)
        if (const cl_uint* const words = count.read.arrived()) count.use(sums, words);
}

void StatisticsLog::enable(bool enabled) {
    Pending dropped;
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(dropped, pending_);
    enabled_ = enabled;
    sums_ = {};
    ++period_;
}

bool StatisticsLog::enabled() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return enabled_;
}

void StatisticsLog::add_command(cl_uint stage, cl_event event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (enabled_) pending_.commands.push_back({stage, Event::retained(event)});
}

void StatisticsLog::add(const std::function<void(rsh_statistics&)>& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (enabled_) change(sums_);
}

void StatisticsLog::add_read(CountRead read) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (enabled_) pending_.reads.push_back(std::move(read));
}

rsh_statistics StatisticsLog::sum() {
    const std::lock_guard<std::mutex> settling(settling_);
    settle();
    const std::lock_guard<std::mutex> lock(mutex_);
    return sums_;
}

// Folds what was recorded into the sums, so that a long count stays small. What another
// thread's enable() dropped meanwhile is not of this count any more.
void StatisticsLog::settle() {
    Pending taken;
    unsigned period = 0;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        std::swap(taken, pending_);
        period = period_;
    }
    taken.wait();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (period == period_) taken.add_to(sums_);
}

}  // namespace rsh
