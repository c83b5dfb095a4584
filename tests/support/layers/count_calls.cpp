// count_calls.cpp - one template per thing that a call does, over the entry of OpenCL's table.
#include "support/layers/count_calls.hpp"

#include <tuple>

#include "support/layers/objects.hpp"

namespace layer {
namespace {

using Word = size_t rsh_counts::*;
constexpr int kNowhere = -1;

// A driver may make one wait of another through the table: the outermost counts.
thread_local int waits_under_way = 0;

class Wait {
public:
    explicit Wait(bool waits) : waits_(waits) {
        if (waits_ && waits_under_way++ == 0) objects().count(&rsh_counts::waits);
    }
    ~Wait() {
        if (waits_) --waits_under_way;
    }
    Wait(const Wait&) = delete;
    Wait& operator=(const Wait&) = delete;

private:
    bool waits_;
};

template <auto Entry>
struct Call;

template <class Result, class... Arguments,
          Result (CL_API_CALL* cl_icd_dispatch::*Entry)(Arguments...)>
struct Call<Entry> {
    using Values = std::tuple<Arguments...>;

    template <Kind kind>
    static Result CL_API_CALL make(Arguments... arguments) {
        const Result made = (below.*Entry)(arguments...);
        if (made) objects().add(made, kind);
        return made;
    }

    static Result CL_API_CALL retain(Arguments... arguments) {
        const Result status = (below.*Entry)(arguments...);
        if (status == CL_SUCCESS) (objects().retain(arguments), ...);
        return status;
    }

    // First out of the table: another thread may be given the handle at once.
    static Result CL_API_CALL release(Arguments... arguments) {
        (objects().release(arguments), ...);
        return (below.*Entry)(arguments...);
    }

    static Result CL_API_CALL wait(Arguments... arguments) {
        const Wait wait(true);
        return (below.*Entry)(arguments...);
    }

    // Blocking: the place of that argument. event: of the event, from the end.
    template <auto word, int blocking, int event>
    static Result CL_API_CALL enqueue(Arguments... arguments) {
        const Values values(arguments...);
        bool blocks = false;
        if constexpr (blocking != kNowhere) blocks = std::get<blocking>(values) != CL_FALSE;
        const Wait wait(blocks);
        if constexpr (word != nullptr) objects().count(word);
        const Result result = (below.*Entry)(arguments...);
        cl_event* const made = std::get<sizeof...(Arguments) - event>(values);
        if (made && *made && succeeded(result)) objects().add(*made, Kind::event);
        return result;
    }

private:
    static bool succeeded(cl_int status) { return status == CL_SUCCESS; }
    static bool succeeded(const void* mapped) { return mapped != nullptr; }
};

constexpr Word kNone = nullptr;
constexpr Word kLaunch = &rsh_counts::launches;
constexpr Word kFill = &rsh_counts::fills;
constexpr Word kCopy = &rsh_counts::copies;

#define RSH_CALL(name, ...) (calls.name = Call<&cl_icd_dispatch::name>::__VA_ARGS__)

void count_objects(cl_icd_dispatch& calls) {
    RSH_CALL(clCreateContext, make<Kind::context>);
    RSH_CALL(clCreateContextFromType, make<Kind::context>);
    RSH_CALL(clCreateCommandQueue, make<Kind::queue>);
    RSH_CALL(clCreateCommandQueueWithProperties, make<Kind::queue>);
    RSH_CALL(clCreateProgramWithSource, make<Kind::program>);
    RSH_CALL(clCreateProgramWithIL, make<Kind::program>);
    RSH_CALL(clCreateProgramWithBuiltInKernels, make<Kind::binary_program>);
    RSH_CALL(clCreateKernel, make<Kind::kernel>);
    RSH_CALL(clCloneKernel, make<Kind::kernel>);
    RSH_CALL(clCreateUserEvent, make<Kind::event>);
    RSH_CALL(clRetainContext, retain);
    RSH_CALL(clRetainCommandQueue, retain);
    RSH_CALL(clRetainMemObject, retain);
    RSH_CALL(clRetainProgram, retain);
    RSH_CALL(clRetainKernel, retain);
    RSH_CALL(clRetainEvent, retain);
    RSH_CALL(clReleaseContext, release);
    RSH_CALL(clReleaseCommandQueue, release);
    RSH_CALL(clReleaseMemObject, release);
    RSH_CALL(clReleaseProgram, release);
    RSH_CALL(clReleaseKernel, release);
    RSH_CALL(clReleaseEvent, release);
}

void count_commands(cl_icd_dispatch& calls) {
    RSH_CALL(clEnqueueNDRangeKernel, enqueue<kLaunch, kNowhere, 1>);
    RSH_CALL(clEnqueueTask, enqueue<kLaunch, kNowhere, 1>);
    RSH_CALL(clEnqueueFillBuffer, enqueue<kFill, kNowhere, 1>);
    RSH_CALL(clEnqueueCopyBuffer, enqueue<kCopy, kNowhere, 1>);
    RSH_CALL(clEnqueueCopyBufferRect, enqueue<kCopy, kNowhere, 1>);
    RSH_CALL(clEnqueueReadBuffer, enqueue<kCopy, 2, 1>);
    RSH_CALL(clEnqueueWriteBuffer, enqueue<kCopy, 2, 1>);
    RSH_CALL(clEnqueueReadBufferRect, enqueue<kCopy, 2, 1>);
    RSH_CALL(clEnqueueWriteBufferRect, enqueue<kCopy, 2, 1>);
    RSH_CALL(clEnqueueReadImage, enqueue<kCopy, 2, 1>);
    RSH_CALL(clEnqueueWriteImage, enqueue<kCopy, 2, 1>);
    RSH_CALL(clEnqueueMapBuffer, enqueue<kNone, 2, 2>);
    RSH_CALL(clEnqueueMapImage, enqueue<kNone, 2, 2>);
    RSH_CALL(clEnqueueUnmapMemObject, enqueue<kNone, kNowhere, 1>);
    RSH_CALL(clEnqueueMigrateMemObjects, enqueue<kNone, kNowhere, 1>);
    RSH_CALL(clEnqueueNativeKernel, enqueue<kNone, kNowhere, 1>);
    RSH_CALL(clEnqueueMarker, enqueue<kNone, kNowhere, 1>);
    RSH_CALL(clEnqueueMarkerWithWaitList, enqueue<kNone, kNowhere, 1>);
    RSH_CALL(clEnqueueBarrierWithWaitList, enqueue<kNone, kNowhere, 1>);
    RSH_CALL(clFinish, wait);
    RSH_CALL(clWaitForEvents, wait);
}

#undef RSH_CALL

}  // namespace

void count_calls(cl_icd_dispatch& calls) {
    count_objects(calls);
    count_commands(calls);
}

}  // namespace layer
