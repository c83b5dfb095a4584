// calls.hpp - how a function of the C interface runs: checks everything, lets a pass enqueue or measure, and
// turns exceptions into a status.
#pragma once

#include "api/check.hpp"
#include "api/settle.hpp"
#include "device/cl/recorder.hpp"

namespace rsh {

// Checks everything, then lets `pass` enqueue, then hands out the event; the recorder does so
// also when `pass` throws.
template <class Desc, class Pass>
rsh_status enqueue(rsh_context context, const Submission& submission, const Desc* desc,
                   cl_event* done, Pass pass) {
    return guarded([&] {
        if (done) *done = nullptr;
        Context& checked = checked_context(context);
        const Received<Desc> received(desc);
        check_submission(checked, submission.queue, submission.wait_count,
                         submission.wait_list);
        const Desc settled = settled_shape(checked, *received);
        check_buffers(checked, settled);
        Recorder recorder(checked, submission, done);
        pass(recorder, settled);
        recorder.finish();
    });
}

// Checks all but the buffers, then lets `measure` tell the sizes.
template <class Desc, class Measure>
rsh_status query(rsh_context context, const Desc* desc, rsh_sizes* sizes, Measure measure) {
    return guarded([&] {
        const Context& checked = checked_context(context);
        const Received<Desc> received(desc);
        check_struct(sizes, "sizes", "sizes.struct_size");
        const Desc settled = settled_shape(checked, *received);
        hand_back(measure(checked, settled), sizes);
    });
}

inline rsh_sizes sizes_of(size_t output_bytes, size_t scratch_bytes) {
    return {sizeof(rsh_sizes), output_bytes, scratch_bytes};
}

}  // namespace rsh
