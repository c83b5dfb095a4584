// rsh.hpp - rsh.h for C++11: contexts that free themselves, descriptors that know their size, and
// failures as exceptions. Header only; everything else is called as rsh.h declares it:
//
//   rsh::Context context(cl_context_, device);  // or all of them at once: rsh::Device
//   auto build = rsh::make<rsh_build_desc>();
//   build.rays = rays;
//   build.width = ray_count;
//   build.nodes = nodes;
//   rsh::check(rsh_build(context.get(), queue, &build, 0, nullptr, &done));
//
// Only rsh::Device owns OpenCL objects; all others stay the caller's, as in C.
#ifndef RSH_HPP
#define RSH_HPP

#include <rsh/rsh.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace rsh {

// The library has classes of its own in namespace rsh. The inline namespace keeps their symbols
// apart from these when the static library is linked; nobody needs to write it.
inline namespace api {

// A call that failed: its status, and as what() the status's text and rsh_last_error().
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
    throw Error(status,
                rsh_status_string(status) + (message.empty() ? message : ": " + message));
}

// A descriptor, or a struct to be filled, with struct_size set and every other member zero,
// which means its default.
template <class Struct>
Struct make() {
    Struct result = Struct();
    result.struct_size = sizeof(Struct);
    return result;
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

// For rsh_context_desc::log: a line on stderr.
inline void log_to_stderr(const char* message, void*) {
    std::fprintf(stderr, "rsh: %s\n", message);
}

// What programs log with: log_to_stderr if the environment has RSH_LOG=1, else NULL, silence.
// The library itself never looks at that.
inline rsh_log log_from_environment() {
    const char* value = std::getenv("RSH_LOG");
    return value && std::string(value) == "1" ? log_to_stderr : nullptr;
}

// A device with an OpenCL context, a queue and an rsh context of its own, for programs that have
// none. Can be moved, not copied. Its destruction waits for nothing; see rsh_release_context.
class Device {
public:
    // `name` as in rsh_find_device; `properties` of the queue: CL_QUEUE_PROFILING_ENABLE,
    // CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE.
    explicit Device(const char* name = nullptr, cl_command_queue_properties properties = 0,
                    rsh_log log = nullptr)
        : platform_(nullptr), device_(nullptr), rsh_(static_cast<rsh_context>(nullptr)) {
        check(rsh_find_device(name, &platform_, &device_));
        cl_int status = CL_SUCCESS;
        context_.reset(clCreateContext(nullptr, 1, &device_, nullptr, nullptr, &status));
        check_opencl(status, "clCreateContext");
        queue_.reset(clCreateCommandQueue(context(), device_, properties, &status));
        check_opencl(status, "clCreateCommandQueue");
        rsh_context_desc desc = make<rsh_context_desc>();
        desc.context = context();
        desc.device = device_;
        desc.log = log;
        rsh_ = Context(desc);
    }

    // For OpenCL's and rsh's calls; all live as long as this object.
    cl_platform_id platform() const noexcept { return platform_; }
    cl_device_id device() const noexcept { return device_; }
    cl_context context() const noexcept { return context_.get(); }
    cl_command_queue queue() const noexcept { return queue_.get(); }
    rsh_context rsh() const noexcept { return rsh_.get(); }

private:
    struct Release {
        void operator()(cl_context context) const { clReleaseContext(context); }
        void operator()(cl_command_queue queue) const { clReleaseCommandQueue(queue); }
    };
    template <class Handle>
    using Owned = std::unique_ptr<typename std::remove_pointer<Handle>::type, Release>;

    static void check_opencl(cl_int status, const char* call) {
        if (status != CL_SUCCESS)
            throw Error(status, std::string(call) + ": " + rsh_status_string(status));
    }

    cl_platform_id platform_;
    cl_device_id device_;
    Owned<cl_context> context_;
    Owned<cl_command_queue> queue_;
    Context rsh_;
};

}  // namespace api
}  // namespace rsh

#endif  // RSH_HPP
