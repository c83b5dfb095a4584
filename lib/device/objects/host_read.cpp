#include "device/objects/host_read.hpp"

#include "device/objects/waiting.hpp"

namespace rsh {
namespace {

void CL_CALLBACK free_words(cl_event, cl_int, void* words) {
    delete[] static_cast<cl_uint*>(words);
}

}  // namespace

HostRead::HostRead(cl_command_queue queue, cl_mem buffer, size_t word_count, const Waits& waits)
    : words_(new cl_uint[word_count]) {
    require_success(opencl(queue).clEnqueueReadBuffer(
                        queue, buffer, CL_FALSE, 0, word_count * sizeof(cl_uint), words_.get(),
                        waits.count, waits.events, event_.out()),
                    "clEnqueueReadBuffer");
}

HostRead::~HostRead() {
    if (!words_ || !event_ || has_ended(event_.get())) return;
    cl_uint* const words = words_.release();
    // A failure leaks them, on purpose.
    opencl(event_.get()).clSetEventCallback(event_.get(), CL_COMPLETE, free_words, words);
}

Event HostRead::share_event() noexcept {
    given_up_ = opencl(event_.get()).clRetainEvent(event_.get());
    if (given_up_ == CL_SUCCESS) return Event(event_.get());
    static_cast<void>(words_.release());  // leaked, on purpose
    return std::move(event_);
}

const cl_uint* HostRead::wait() const {
    require_success(given_up_, "clRetainEvent");
    wait_for(event_.get());
    return words_.get();
}

const cl_uint* HostRead::arrived() const noexcept {
    return event_ && status_of(event_.get()) == CL_COMPLETE ? words_.get() : nullptr;
}

}  // namespace rsh
