#include "device/cl/statistics_log.hpp"

namespace rsh {
namespace {

// CL_COMPLETE, above it while under way, below it after a failure.
cl_int status_of(const cl::Event& event) {
    cl_int status = CL_QUEUED;
    clGetEventInfo(event(), CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof status, &status, nullptr);
    return status;
}

// A command that failed makes the wait fail; it has ended all the same.
void wait_for(const cl::Event& event) {
    clWaitForEvents(1, &event());
}

// CL_PROFILING_INFO_NOT_AVAILABLE is no failure: the queue does not measure, or the command
// failed.
cl_ulong duration_ns(const cl::Event& event) {
    cl_ulong start = 0, end = 0;
    if (clGetEventProfilingInfo(event(), CL_PROFILING_COMMAND_START, sizeof start, &start,
                                nullptr) != CL_SUCCESS ||
        clGetEventProfilingInfo(event(), CL_PROFILING_COMMAND_END, sizeof end, &end, nullptr) !=
            CL_SUCCESS)
        return 0;
    return end > start ? end - start : 0;
}

void CL_CALLBACK free_words(cl_event, cl_int, void* words) {
    delete[] static_cast<cl_uint*>(words);
}

}  // namespace

// A callback instead of a wait: the read may hang on an event that the caller sets only later.
CountRead::~CountRead() {
    if (!words_ || !event_() || status_of(event_) <= CL_COMPLETE) return;
    if (clSetEventCallback(event_(), CL_COMPLETE, free_words, words_.get()) == CL_SUCCESS)
        words_.release();
    else
        wait_for(event_);
}

void CountRead::wait() const {
    wait_for(event_);
}

void CountRead::add_to(rsh_statistics& sums) const {
    if (status_of(event_) == CL_COMPLETE) use_(sums, words_.get());
}

void StatisticsLog::Pending::wait() const {
    for (const Command& command : commands) wait_for(command.event);
    for (const CountRead& read : reads) read.wait();
}

void StatisticsLog::Pending::add_to(rsh_statistics& sums) const {
    for (const Command& command : commands) {
        sums.stage_ns[command.stage] += duration_ns(command.event);
        ++sums.launches;
    }
    for (const CountRead& read : reads) read.add_to(sums);
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

void StatisticsLog::add_command(cl_uint stage, const cl::Event& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (enabled_) pending_.commands.push_back({stage, event});
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
