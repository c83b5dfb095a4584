// error.hpp - how failures travel inside the library: as Error, until api/rsh.cpp turns them
// into a status. Nothing here prints or aborts.
#pragma once

#include <rsh/rsh.h>

#include <stdexcept>
#include <string>

namespace rsh {

class Error : public std::runtime_error {
public:
    Error(rsh_status status, const std::string& message)
        : std::runtime_error(message), status_(status) {}
    rsh_status status() const noexcept { return status_; }

private:
    rsh_status status_;
};

// The text behind rsh_last_error(), one per thread.
const char* last_error() noexcept;
void set_last_error(const std::string& message) noexcept;
void clear_last_error() noexcept;

// Name of an OpenCL error code ("CL_OUT_OF_RESOURCES"); NULL for other numbers.
const char* opencl_error_name(cl_int code) noexcept;

// Runs `body` and turns what it throws into a status: no exception crosses the C boundary.
rsh_status guarded_call(void (*body)(void*), void* argument) noexcept;

template <class Body>
rsh_status guarded(Body body) noexcept {
    return guarded_call([](void* argument) { (*static_cast<Body*>(argument))(); }, &body);
}

}  // namespace rsh
