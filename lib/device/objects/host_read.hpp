// host_read.hpp - a read of words that does not block. Memory that a device may still write is never
// freed: where a read can neither be waited for nor tell when it ends, its words are given up.
#pragma once

#include <memory>

#include "device/objects/handle.hpp"

namespace rsh {

class HostRead {
public:
    // Enqueues a read of words from the front of `buffer`, after `waits`.
    HostRead(cl_command_queue queue, cl_mem buffer, size_t word_count, const Waits& waits);
    // Under way, it leaves the words to a callback of the read's: waiting may take until the
    // caller sets an event.
    ~HostRead();
    HostRead(HostRead&&) noexcept = default;
    HostRead& operator=(HostRead&&) = delete;

    // Another reference to the read's event, in any case: if there can be no other, its own, and
    // then the words never arrive.
    Event share_event() noexcept;

    cl_event event() const noexcept { return event_.get(); }
    // BLOCKS. Throws when the words do not arrive.
    const cl_uint* wait() const;
    // The words, or NULL if they did not arrive.
    const cl_uint* arrived() const noexcept;

private:
    std::unique_ptr<cl_uint[]> words_;
    Event event_;
    cl_int given_up_ = CL_SUCCESS;  // why
};

}  // namespace rsh
