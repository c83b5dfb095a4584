// rsh.hpp - rsh.h for C++11: a context that frees itself, descriptors that know their size, and
// failures as exceptions. Header only; everything else is called as rsh.h declares it:
//
//   rsh::Context context(cl_context_, device);
//   auto build = rsh::make<rsh_build_desc>();
//   build.rays = rays;
//   build.width = ray_count;
//   build.nodes = nodes;
//   rsh::check(rsh_build(context.get(), queue, &build, 0, nullptr, &done));
//
// It owns no OpenCL object: contexts, queues, buffers and events stay the caller's, as in C.
#ifndef RSH_HPP
#define RSH_HPP

#include <rsh/rsh.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace rsh {

// The library has classes of its own in namespace rsh. The inline namespace keeps their symbols
// apart from these when the static library is linked; nobody needs to write it.
inline namespace api {

// A call that failed: its status, and as what() the text of rsh_last_error().
class Error : public std::runtime_error {
public:
    Error(rsh_status status, const std::string& message)
        : std::runtime_error(message), status_(status) {}

    rsh_status status() const noexcept { return status_; }

private:
    rsh_status status_;
};

// Throws Error unless `status` is RSH_SUCCESS. To be called on the thread that made the call,
// before its next one: the message is the thread's.
inline void check(rsh_status status) {
    if (status == RSH_SUCCESS) return;
    const std::string message = rsh_last_error();
    throw Error(status, message.empty() ? rsh_status_string(status) : message);
}

// A descriptor, or a struct to be filled, with struct_size set and every other member zero,
// which means its default.
template <class Struct>
Struct make() {
    Struct result = Struct();
    result.struct_size = sizeof(Struct);
    return result;
}

// A device, for programs that have none yet; see rsh_find_device.
struct Device {
    cl_platform_id platform;
    cl_device_id device;
};

inline Device find_device(const char* name = nullptr) {
    Device found = Device();
    check(rsh_find_device(name, &found.platform, &found.device));
    return found;
}

// Owns an rsh_context. Can be moved, not copied. Its destruction must be the last call on the
// context; see rsh_release_context.
class Context {
public:
    explicit Context(const rsh_context_desc& desc) : handle_(nullptr) {
        check(rsh_create_context(&desc, &handle_));
    }

    Context(cl_context context, cl_device_id device) : handle_(nullptr) {
        rsh_context_desc desc = make<rsh_context_desc>();
        desc.context = context;
        desc.device = device;
        check(rsh_create_context(&desc, &handle_));
    }

    // Takes over a context that rsh_create_context made; NULL is none.
    explicit Context(rsh_context handle) noexcept : handle_(handle) {}

    Context(Context&& other) noexcept : handle_(other.release()) {}

    Context& operator=(Context&& other) noexcept {
        Context taken(std::move(other));
        std::swap(handle_, taken.handle_);
        return *this;
    }

    ~Context() { rsh_release_context(handle_); }

    // For the C calls. NULL after a move.
    rsh_context get() const noexcept { return handle_; }

    // Hands the context, and the duty to release it, to the caller.
    rsh_context release() noexcept {
        const rsh_context handle = handle_;
        handle_ = nullptr;
        return handle;
    }

private:
    rsh_context handle_;
};

}  // namespace api
}  // namespace rsh

#endif  // RSH_HPP
