// handle.hpp - OpenCL 1.2 as the library calls it: objects that release themselves, failures as
// Error. The C++ bindings are not used: where a call fails they throw inside of noexcept, and
// release what they failed to retain.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "device/error.hpp"
#include "device/objects/opencl.hpp"

namespace rsh {

inline void require_success(cl_int status, const char* call) {
    if (status != CL_SUCCESS) throw opencl_error(status, call);
}

// The calls of OpenCL on objects of a type.
template <class Id>
struct Calls;
#define RSH_CALLS(id, get_info)                                                 \
    template <>                                                                 \
    struct Calls<id> {                                                          \
        static constexpr const char* query_name = #get_info;                    \
        static cl_int query(id object, cl_uint what, size_t bytes, void* value, \
                            size_t* needed) {                                   \
            return opencl(object).get_info(object, what, bytes, value, needed); \
        }
#define RSH_COUNTED_CALLS(id, retain_object, release_object, get_info) \
    RSH_CALLS(id, get_info)                                            \
    static constexpr const char* retain_name = #retain_object;         \
    static cl_int retain(id object) {                                  \
        return opencl(object).retain_object(object);                   \
    }                                                                  \
    static cl_int release(id object) {                                 \
        return opencl(object).release_object(object);                  \
    }                                                                  \
    }
RSH_CALLS(cl_platform_id, clGetPlatformInfo)
};
RSH_CALLS(cl_device_id, clGetDeviceInfo)
}
;
RSH_COUNTED_CALLS(cl_context, clRetainContext, clReleaseContext, clGetContextInfo);
RSH_COUNTED_CALLS(cl_command_queue, clRetainCommandQueue, clReleaseCommandQueue,
                  clGetCommandQueueInfo);
RSH_COUNTED_CALLS(cl_mem, clRetainMemObject, clReleaseMemObject, clGetMemObjectInfo);
RSH_COUNTED_CALLS(cl_program, clRetainProgram, clReleaseProgram, clGetProgramInfo);
RSH_COUNTED_CALLS(cl_kernel, clRetainKernel, clReleaseKernel, clGetKernelInfo);
RSH_COUNTED_CALLS(cl_event, clRetainEvent, clReleaseEvent, clGetEventInfo);
#undef RSH_COUNTED_CALLS
#undef RSH_CALLS

// One reference to an object, or to none. Moved, never copied: another reference is asked for, as
// that may fail. Nothing can be done about one that OpenCL fails to release.
template <class Id>
class Handle {
public:
    Handle() noexcept = default;
    // Takes over the caller's reference.
    explicit Handle(Id owned) noexcept : id_(owned) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, nullptr)) {}
    Handle& operator=(Handle&& other) noexcept {
        Handle taken(std::move(other));
        std::swap(id_, taken.id_);
        return *this;
    }
    ~Handle() {
        if (id_) Calls<Id>::release(id_);
    }

    static Handle retained(Id id) {
        require_success(Calls<Id>::retain(id), Calls<Id>::retain_name);
        return Handle(id);
    }
    // The same, or none where it fails.
    static Handle retained_or_none(Id id) noexcept {
        return Handle(Calls<Id>::retain(id) == CL_SUCCESS ? id : nullptr);
    }

    Id get() const noexcept { return id_; }
    explicit operator bool() const noexcept { return id_ != nullptr; }
    // For calls that create an object; the handle holds none.
    Id* out() noexcept { return &id_; }
    // For calls that take a list.
    const Id* list() const noexcept { return &id_; }
    // Hands the reference to the caller.
    Id release() noexcept { return std::exchange(id_, nullptr); }

private:
    Id id_ = nullptr;
};

using Buffer = Handle<cl_mem>;
using Event = Handle<cl_event>;
using Kernel = Handle<cl_kernel>;

// What a command waits for.
struct Waits {
    cl_uint count;
    const cl_event* events;  // NULL: none
};

inline const cl_event* list_of(const std::vector<Event>& events) noexcept {
    static_assert(sizeof(Event) == sizeof(cl_event) && std::is_standard_layout_v<Event>);
    return events.empty() ? nullptr : reinterpret_cast<const cl_event*>(events.data());
}

// A value that OpenCL knows of an object. Of an object it gives no reference.
template <class Value, class Id>
Value info(Id object, cl_uint what) {
    Value value = {};
    require_success(Calls<Id>::query(object, what, sizeof value, &value, nullptr),
                    Calls<Id>::query_name);
    return value;
}

template <class Value, class Id>
std::vector<Value> info_list(Id object, cl_uint what) {
    size_t bytes = 0;
    require_success(Calls<Id>::query(object, what, 0, nullptr, &bytes), Calls<Id>::query_name);
    std::vector<Value> values(bytes / sizeof(Value));
    if (values.empty()) return values;
    require_success(Calls<Id>::query(object, what, bytes, values.data(), nullptr),
                    Calls<Id>::query_name);
    return values;
}

// Without the end that OpenCL counts in.
template <class Id>
std::string info_text(Id object, cl_uint what) {
    const std::vector<char> text = info_list<char>(object, what);
    return {text.begin(), text.empty() ? text.end() : text.end() - 1};
}

Buffer new_buffer(cl_context context, cl_mem_flags flags, size_t bytes,
                  const void* contents = nullptr);

// Local memory as an argument of a kernel.
struct LocalBytes {
    size_t bytes;
};

}  // namespace rsh
