// recorder.hpp - enqueues one call's work: borrows kernels, sets their arguments, launches them
// in order, keeps their events. The only code that enqueues anything. Or notes only which programs
// the call would need.
#pragma once

#include <rsh/rsh.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "device/cl/context.hpp"
#include "device/cl/work_group.hpp"
#include "device/layout.hpp"
#include "device/objects/handle.hpp"
#include "device/objects/host_write.hpp"

namespace rsh {

// The caller's queue and the events to start after; see "Async" in rsh.h.
struct Submission {
    cl_command_queue queue;
    cl_uint wait_count;
    const cl_event* wait_list;
};

// Enough work-items to fill the device, for a stream whose length only the device knows; see
// kernels/lanes/stride.h. No more of them than `most` elements.
Range stream_range(const Context& context, size_t most = SIZE_MAX);

class Recorder {
public:
    // `done` may be NULL. The destructor sets *done to the last command, also after a failure
    // in the middle, so that the caller learns when its buffers are free again.
    Recorder(Context& context, const Submission& submission, cl_event* done);
    // Enqueues nothing, borrows nothing and looks at no buffer; counts on the device are read as 0.
    Recorder(Context& context, NeededPrograms& needed);
    ~Recorder();
    bool only_notes() const { return needed_ != nullptr; }
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    Context& context() { return context_; }

    // Enqueues a kernel after everything recorded before. Arguments in the kernel's order:
    // cl_mem, LocalBytes, scalars and structs. An empty range enqueues nothing.
    template <class... Arguments>
    void launch(cl_uint stage, const KernelName& name, const Range& range,
                const Arguments&... arguments) {
        if (range.items == 0) return;
        if (needed_) return needed_->add(name);
        const KernelName taken = context_.for_call(name);
        BorrowedKernel kernel = context_.programs.borrow(taken);
        cl_uint index = 0;
        (set_argument(kernel.get(), index++, arguments), ...);
        enqueue(stage, name, kernel.get(), range);
        if (taken.is_variant != name.is_variant) count_general_launch();
    }

    // Has a kernel there that later calls launch, so that these make nothing.
    void expect(const KernelName& name);

    // One work-item per element, in groups of the device's usual size.
    Range range(size_t items) const { return {items, context_.caps.group_size, true}; }

    // The same for long work-items, a tile of rays or more each: no groups on CPUs.
    Range serial_range(size_t items) const {
        return {items, context_.vector_width > 1 ? 1 : context_.caps.group_size, true};
    }

    Range stream_range(size_t most = SIZE_MAX) const {
        return rsh::stream_range(context_, most);
    }

    // Sets `bytes` of `buffer` from `offset` on (multiples of 4) to a repeated word.
    void fill(cl_uint stage, cl_mem buffer, cl_uint word, size_t bytes, size_t offset = 0);
    // Changes the statistics at once.
    void count(const std::function<void(rsh_statistics&)>& change);
    // Adds words from the front of `buffer` to the statistics, once they arrived.
    void count_later(cl_mem buffer, size_t word_count, CountRead::Use use);
    // Copies the front of the host's memory to that of `buffer`.
    void write(cl_uint stage, HostWrite& from, cl_mem buffer, size_t bytes);
    // What was recorded begins to run, and of its events only the last one is kept, which ends after all
    // others; for calls that go on for long.
    void flush();
    // Copies a word of `from` to the word `index` of `to`.
    void copy_word(cl_mem from, cl_mem to, size_t index);
    // BLOCKS until the caller's events ended, and throws when one failed. For a call that will
    // block, before it enqueues anything.
    void wait_for_callers();
    // BLOCKS for words from the front of `buffer`; rsh_frame only.
    std::vector<cl_uint> read_now(cl_mem buffer, size_t word_count);

    // The word that takes what traversals meet that was not made for them: the context's, or
    // one of the call's own, which is 0 from then on.
    cl_mem wrong_buffers() const { return wrong_buffers_; }
    void own_wrong_buffers(cl_mem word);

    // Memory of the context's pool that no other call touches until this call's commands ended.
    cl_mem borrow_scratch(size_t bytes);

    // Sees to an event for the caller when nothing was enqueued: one for the end of the wait
    // list.
    void finish();

private:
    static void set_argument(cl_kernel kernel, cl_uint index, LocalBytes local) {
        require_success(opencl(kernel).clSetKernelArg(kernel, index, local.bytes, nullptr),
                        "clSetKernelArg");
    }
    template <class Value>
    static void set_argument(cl_kernel kernel, cl_uint index, const Value& value) {
        require_success(opencl(kernel).clSetKernelArg(kernel, index, sizeof value, &value),
                        "clSetKernelArg");
    }
    void count_general_launch();
    void enqueue(cl_uint stage, const KernelName& name, cl_kernel kernel, const Range& range);
    void record(cl_uint stage, Event event);
    void continue_after(Event event);
    // What the next command waits for. Makes room for its event, which then cannot be lost.
    Waits prepare();
    cl_event last_command() const;  // NULL: none yet
    std::vector<Event>& commands() { return call_.front().commands; }
    const std::vector<Event>& commands() const { return call_.front().commands; }

    Context& context_;
    cl_command_queue queue_;
    cl_event* done_;
    cl_mem wrong_buffers_;
    NeededPrograms* needed_ = nullptr;  // where there is one, nothing is enqueued
    std::vector<Event> callers_;        // the wait list
    UnderWay::Calls call_;              // this one, with its commands
    std::vector<ScratchBlock> blocks_;
};

}  // namespace rsh
