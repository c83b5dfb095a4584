#include "device/objects/host_write.hpp"

#include "device/objects/waiting.hpp"

namespace rsh {
namespace {

void CL_CALLBACK free_memory(cl_event, cl_int, void* memory) {
    delete[] static_cast<char*>(memory);
}

}  // namespace

HostWrite::HostWrite(size_t bytes) : memory_(new char[bytes]) {}

HostWrite::~HostWrite() {
    if (!memory_ || !is_under_way()) return;
    char* const memory = memory_.release();
    // A failure leaks it, on purpose.
    opencl(event_.get()).clSetEventCallback(event_.get(), CL_COMPLETE, free_memory, memory);
}

bool HostWrite::is_under_way() const noexcept {
    return event_ && !has_ended(event_.get());
}

void* HostWrite::filled_anew() {
    require_success(given_up_, "clRetainEvent");
    if (event_) wait_for(event_.get());
    event_ = Event();
    return memory_.get();
}

Event HostWrite::enqueue(cl_command_queue queue, cl_mem buffer, size_t bytes,
                         const Waits& waits) {
    require_success(
        opencl(queue).clEnqueueWriteBuffer(queue, buffer, CL_FALSE, 0, bytes, memory_.get(),
                                           waits.count, waits.events, event_.out()),
        "clEnqueueWriteBuffer");
    given_up_ = opencl(event_.get()).clRetainEvent(event_.get());
    if (given_up_ == CL_SUCCESS) return Event(event_.get());
    static_cast<void>(memory_.release());  // leaked, on purpose
    return std::move(event_);
}

}  // namespace rsh
