#include "device/cl/recorder.hpp"

#include "device/error.hpp"

namespace rsh {

Recorder::Recorder(Context& context, const Submission& submission, cl_event* done)
    : context_(context),
      queue_(submission.queue, true),
      done_(done),
      wrong_buffers_(context.wrong_buffers()) {
    waits_.reserve(submission.wait_count + 1);  // to keep the last command is not to fail
    for (cl_uint i = 0; i < submission.wait_count; ++i)
        waits_.emplace_back(submission.wait_list[i], true);
}

// Also after a failure in the middle: what was enqueued may still use the blocks.
Recorder::~Recorder() {
    hand_out_last();
    for (ScratchBlock& block : blocks_) {
        if (enqueued_) block.last_use = waits_.front();
        context_.pool.give_back(std::move(block));
    }
}

void Recorder::enqueue(cl_uint stage, const KernelName& name, const cl::Kernel& kernel,
                       const Range& range) {
    const size_t size =
        range.group_size == 1
            ? 1
            : fitting_group(name.kernel, range, group_limits(kernel, context_.device));
    const size_t groups = (range.items + size - 1) / size;
    cl::Event event;
    try {
        queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(groups * size),
                                    cl::NDRange(size), waits(), &event);
    } catch (const cl::Error& error) {
        const char* code = opencl_error_name(error.err());
        throw Error(error.err(), error.what(), " of ", name.kernel,
                    " failed: ", code ? code : "an unknown code");
    }
    record(stage, event);
}

void Recorder::record(cl_uint stage, const cl::Event& event) {
    continue_after(event);
    context_.statistics.add_command(stage, event);
}

void Recorder::continue_after(const cl::Event& event) {
    waits_.assign(1, event);
    enqueued_ = true;
}

// On CPUs a group is a task: single items, a few per core to balance uneven runs.
Range Recorder::stream_range() const {
    const DeviceCaps& caps = context_.caps;
    const size_t tasks = size_t{caps.compute_units} * 16;
    if (context_.vector_width > 1) return {tasks, 1};
    return {tasks * caps.group_size, caps.group_size, true};
}

void Recorder::fill(cl_uint stage, cl_mem buffer, cl_uint word, size_t bytes, size_t offset) {
    if (bytes == 0) return;
    cl::Event event;
    queue_.enqueueFillBuffer(cl::Buffer(buffer, true), word, offset, bytes, waits(), &event);
    record(stage, event);
}

void Recorder::count_later(cl_mem buffer, size_t word_count, CountRead::Use use) {
    CountRead read(word_count, std::move(use));
    cl::Event event;
    queue_.enqueueReadBuffer(cl::Buffer(buffer, true), CL_FALSE, 0,
                             word_count * sizeof(cl_uint), read.words(), waits(), &event);
    read.began(event);
    continue_after(event);
    context_.statistics.add_read(std::move(read));
}

void Recorder::own_wrong_buffers(cl_mem word) {
    wrong_buffers_ = word;
    fill(RSH_STAGE_OTHER, word, 0, sizeof(cl_uint));
}

void Recorder::copy_word(cl_mem from, cl_mem to, size_t index) {
    cl::Event event;
    queue_.enqueueCopyBuffer(cl::Buffer(from, true), cl::Buffer(to, true), 0,
                             index * sizeof(cl_uint), sizeof(cl_uint), waits(), &event);
    record(RSH_STAGE_OTHER, event);
}

std::array<cl_uint, 2> Recorder::read_now(cl_mem buffer) {
    std::array<cl_uint, 2> words = {};
    cl::Event event;
    queue_.enqueueReadBuffer(cl::Buffer(buffer, true), CL_TRUE, 0, sizeof words, words.data(),
                             waits(), &event);
    record(RSH_STAGE_OTHER, event);
    context_.statistics.add([](rsh_statistics& sums) { ++sums.host_waits; });
    return words;
}

cl_mem Recorder::borrow_scratch(size_t bytes) {
    blocks_.reserve(blocks_.size() + 1);  // what is borrowed is given back
    blocks_.push_back(context_.pool.borrow(bytes, queue_, waits_));
    return blocks_.back().buffer();
}

// The last command ends after all others. No marker behind it: PoCL 3.1 lets one wait for
// whatever the queue holds, also when it is given a wait list and the queue is out of order.
void Recorder::finish() {
    if (!done_ || enqueued_) return;
    cl::Event event;
    queue_.enqueueMarkerWithWaitList(waits(), &event);
    continue_after(event);
}

void Recorder::hand_out_last() const noexcept {
    if (!done_ || !enqueued_) return;
    *done_ = waits_.front()();
    clRetainEvent(*done_);
}

}  // namespace rsh
