// waiting.hpp - events that end, or fail. PoCL's blocking reads succeed without data behind an event
// that fails: so events are looked at.
#pragma once

#include "device/objects/handle.hpp"

namespace rsh {

// CL_COMPLETE, above it while under way or unknown, below it after a failure.
cl_int status_of(cl_event event) noexcept;

// Ended, also by a failure.
inline bool has_ended(cl_event event) noexcept {
    return status_of(event) <= CL_COMPLETE;
}

// BLOCKS until a command of the library's ended. Throws when it failed, or when waiting does.
void wait_for(cl_event event);

}  // namespace rsh
