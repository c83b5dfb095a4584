// trace.cpp - the C boundary of rsh_trace; see api/rsh.cpp.
#include "trace/trace.hpp"

#include "api/calls.hpp"
#include "traverse/engine.hpp"

extern "C" {

rsh_status rsh_trace_query(rsh_context context, const rsh_trace_desc* desc, rsh_sizes* sizes) {
    return rsh::query(context, desc, sizes, [](const auto& own, const auto& checked) {
        return rsh::sizes_of(rsh::answer_bytes(rsh::trace_traverse(checked)),
                             rsh::trace_scratch(own, checked).bytes());
    });
}

rsh_status rsh_trace(rsh_context context, cl_command_queue queue, const rsh_trace_desc* desc,
                     cl_uint wait_count, const cl_event* wait_list, cl_event* done) {
    return rsh::enqueue(context, {queue, wait_count, wait_list}, desc, done, rsh::trace);
}

}  // extern "C"
