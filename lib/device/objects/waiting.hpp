// waiting.hpp - events that end, or fail. PoCL lets a command that is enqueued behind an event that
// failed wait for ever, and its blocking reads succeed without data: so events are looked at.
#pragma once

#include "device/objects/handle.hpp"

namespace rsh {

// CL_COMPLETE, above it while under way or unknown, below it after a failure.
cl_int status_of(cl_event event) noexcept;

// Ended, also by a failure.
inline bool has_ended(cl_event event) noexcept {
    return status_of(event) <= CL_COMPLETE;
}

// Throws when one has failed already.
void require_none_failed(cl_uint count, const cl_event* wait_list);

// BLOCKS until all, at least one, ended. Throws when one failed, or when waiting does.
void wait_for_all(cl_uint count, const cl_event* wait_list);
// The same for a command of the library's.
void wait_for(cl_event event);

}  // namespace rsh
