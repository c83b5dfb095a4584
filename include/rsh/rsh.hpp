// rsh.hpp - rsh.h for C++11: contexts, buffers and events that free themselves, descriptors that know
// their size, arrays of the host to the device and back, and failures as exceptions. Header only. Every
// call of rsh.h is made through run, sizes_of or check:
//
//   rsh::Device device;                          // or one's own context: rsh::Context(context, device_id)
//   const rsh::Buffer rays = device.upload(host_rays);
//   auto build = rsh::make<rsh_build_desc>();
//   build.rays = rays.get();
//   build.width = static_cast<cl_uint>(host_rays.size());
//   const rsh::Buffer nodes = device.buffer(device.sizes_of(rsh_build_query, build).output_bytes);
//   build.nodes = nodes.get();
//   device.run(rsh_build, build);                // enqueues, as in C
//
// Objects that a rsh::Device did not make stay the caller's, as in C.
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
#include <vector>

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
// before its next one: the message is the thread's. `call` names it in the message.
inline void check(rsh_status status, const char* call = nullptr) {
    if (status == RSH_SUCCESS) return;
    const std::string message = rsh_last_error();
    throw Error(status, (call ? std::string(call) + ": " : std::string()) +
                            rsh_status_string(status) +
                            (message.empty() ? message : ": " + message));
}

// The same for a call of OpenCL.
inline void check_opencl(cl_int status, const char* call) {
    if (status != CL_SUCCESS)
        throw Error(status, std::string(call) + ": " + rsh_status_string(status));
}

// A descriptor, or a struct to be filled, with struct_size set and every other member zero,
// which means its default.
template <class Struct>
Struct make() {
    Struct result = Struct();
    result.struct_size = sizeof(Struct);
    return result;
}

// Owns a reference to an object of OpenCL, or none; get() is for the calls. Can be moved, not copied.
struct Release {
    void operator()(cl_context context) const { clReleaseContext(context); }
    void operator()(cl_command_queue queue) const { clReleaseCommandQueue(queue); }
    void operator()(cl_mem memory) const { clReleaseMemObject(memory); }
    void operator()(cl_event event) const { clReleaseEvent(event); }
};
template <class Handle>
using Owned = std::unique_ptr<typename std::remove_pointer<Handle>::type, Release>;
using Buffer = Owned<cl_mem>;
using Event = Owned<cl_event>;

// A buffer to read and write; with `contents`, a copy of so many bytes. OpenCL has none of 0 bytes:
// that is no buffer, NULL in a descriptor.
inline Buffer new_buffer(cl_context context, size_t bytes, const void* contents = nullptr) {
    if (bytes == 0) return Buffer();
    cl_int status = CL_SUCCESS;
    const cl_mem_flags copied = contents ? CL_MEM_COPY_HOST_PTR : 0;
    Buffer buffer(clCreateBuffer(context, CL_MEM_READ_WRITE | copied, bytes,
                                 const_cast<void*>(contents), &status));
    check_opencl(status, "clCreateBuffer");
    return buffer;
}

// Functions like rsh_build_query, and like rsh_build.
template <class Desc>
using Query = rsh_status (*)(rsh_context, const Desc*, rsh_sizes*);
template <class Desc>
using Call = rsh_status (*)(rsh_context, cl_command_queue, const Desc*, cl_uint,
                            const cl_event*, cl_event*);

template <class Desc>
rsh_sizes sizes_of(Query<Desc> query, rsh_context context, const Desc& desc) {
    rsh_sizes sizes = make<rsh_sizes>();
    check(query(context, &desc, &sizes));
    return sizes;
}

// Enqueues the call behind `waits`. The event of its end may be ignored.
template <class Desc>
Event run(Call<Desc> call, rsh_context context, cl_command_queue queue, const Desc& desc,
          const std::vector<cl_event>& waits = {}) {
    cl_event done = nullptr;
    const rsh_status status = call(context, queue, &desc, static_cast<cl_uint>(waits.size()),
                                   waits.empty() ? nullptr : waits.data(), &done);
    Event event(done);
    check(status);
    return event;
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

    Buffer buffer(size_t bytes) const { return new_buffer(context(), bytes); }
    template <class Value>
    Buffer upload(const std::vector<Value>& values) const {
        static_assert(std::is_trivially_copyable<Value>::value, "its bytes are copied");
        return new_buffer(context(), values.size() * sizeof(Value), values.data());
    }

    // Copy values to the front of a buffer, or from there. They BLOCK.
    template <class Value>
    void write(cl_mem to, const std::vector<Value>& values) const {
        static_assert(std::is_trivially_copyable<Value>::value, "its bytes are copied");
        if (values.empty()) return;
        check_opencl(
            clEnqueueWriteBuffer(queue(), to, CL_TRUE, 0, values.size() * sizeof(Value),
                                 values.data(), 0, nullptr, nullptr),
            "clEnqueueWriteBuffer");
    }
    template <class Value>
    void read(cl_mem from, Value* to, size_t count) const {
        static_assert(std::is_trivially_copyable<Value>::value, "its bytes are copied");
        if (count == 0) return;
        check_opencl(clEnqueueReadBuffer(queue(), from, CL_TRUE, 0, count * sizeof(Value), to,
                                         0, nullptr, nullptr),
                     "clEnqueueReadBuffer");
    }
    template <class Value>
    std::vector<Value> download(cl_mem from, size_t count) const {
        std::vector<Value> values(count);
        read(from, values.data(), count);
        return values;
    }

    // As the functions of these names.
    template <class Desc>
    rsh_sizes sizes_of(Query<Desc> query, const Desc& desc) const {
        return api::sizes_of(query, rsh(), desc);
    }
    template <class Desc>
    Event run(Call<Desc> call, const Desc& desc,
              const std::vector<cl_event>& waits = {}) const {
        return api::run(call, rsh(), queue(), desc, waits);
    }

private:
    cl_platform_id platform_;
    cl_device_id device_;
    Owned<cl_context> context_;
    Owned<cl_command_queue> queue_;
    Context rsh_;
};

}  // namespace api
}  // namespace rsh

#endif  // RSH_HPP
