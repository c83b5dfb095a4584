// error.hpp - how failures travel inside the library: as Error, until api/rsh.cpp turns them
// into a status. Nothing here prints, aborts or takes memory: one of the failures is that there is
// none.
#pragma once

#include <rsh/rsh.h>

#include <exception>

#include "device/text.hpp"

namespace rsh {

// The text behind rsh_last_error(), one per thread.
const char* last_error() noexcept;
void clear_last_error() noexcept;
// To be filled in place of the last one.
Text new_error_text() noexcept;

// Its text is the thread's: the next Error that is made on the thread replaces it. So none is made
// while another is under way, in destructors.
class Error : public std::exception {
public:
    // The parts of the text: strings, characters, numbers.
    template <class... Parts>
    explicit Error(rsh_status status, const Parts&... parts) noexcept : status_(status) {
        new_error_text().add(parts...);
    }
    rsh_status status() const noexcept { return status_; }
    const char* what() const noexcept override { return last_error(); }

private:
    rsh_status status_;
};

// Name of an OpenCL error code ("CL_OUT_OF_RESOURCES"); NULL for other numbers.
const char* opencl_error_name(cl_int code) noexcept;

// Of a call of OpenCL that failed.
Error opencl_error(cl_int code, const char* call) noexcept;

// Runs `body` and turns what it throws into a status: no exception crosses the C boundary.
rsh_status guarded_call(void (*body)(void*), void* argument) noexcept;

template <class Body>
rsh_status guarded(Body body) noexcept {
    return guarded_call([](void* argument) { (*static_cast<Body*>(argument))(); }, &body);
}

}  // namespace rsh
