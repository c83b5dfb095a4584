#include "device/cl/recorder.hpp"

#include <algorithm>

#include "device/error.hpp"
#include "device/objects/waiting.hpp"

namespace rsh {

Recorder::Recorder(Context& context, const Submission& submission, cl_event* done)
    : context_(context),
      queue_(submission.queue),
      done_(done),
      wrong_buffers_(context.wrong_buffers()),
      call_(1) {
    callers_.reserve(submission.wait_count);
    for (cl_uint i = 0; i < submission.wait_count; ++i)
        callers_.push_back(Event::retained(submission.wait_list[i]));
}

Recorder::Recorder(Context& context, NeededPrograms& needed)
    : context_(context),
      queue_(nullptr),
      done_(nullptr),
      wrong_buffers_(context.wrong_buffers()),
      needed_(&needed),
      call_(1) {}

// Also after a failure in the middle: what was enqueued may still use the blocks.
Recorder::~Recorder() {
    const cl_event last = last_command();
    for (ScratchBlock& block : blocks_) {
        if (last) block.last_use = Event::retained_or_none(last);
        if (last && !block.last_use)
            context_.pool.give_up(std::move(block));
        else
            context_.pool.give_back(std::move(block));
    }
    if (done_ && last) {
        *done_ = last;
        if (opencl(last).clRetainEvent(last) != CL_SUCCESS)
            static_cast<void>(commands().back().release());
    }
    while (!commands().empty() && !commands().back()) commands().pop_back();
    context_.under_way.keep(std::move(call_));
}

void Recorder::expect(const KernelName& name) {
    if (needed_) return needed_->add(name);
    context_.programs.borrow(context_.for_call(name));
}

cl_event Recorder::last_command() const {
    return commands().empty() ? nullptr : commands().back().get();
}

Waits Recorder::prepare() {
    std::vector<Event>& made = commands();
    if (made.size() == made.capacity()) made.reserve(2 * made.size() + 8);
    if (!made.empty()) return {1, made.back().list()};
    return {static_cast<cl_uint>(callers_.size()), list_of(callers_)};
}

void Recorder::enqueue(cl_uint stage, const KernelName& name, cl_kernel kernel,
                       const Range& range) {
    const size_t size =
        range.group_size == 1
            ? 1
            : fitting_group(name.kernel, range, group_limits(kernel, context_.device));
    const size_t items = (range.items + size - 1) / size * size;
    const Waits waits = prepare();
    Event event;
    const cl_int status = opencl(queue_).clEnqueueNDRangeKernel(
        queue_, kernel, 1, nullptr, &items, &size, waits.count, waits.events, event.out());
    if (status != CL_SUCCESS) {
        const char* const code = opencl_error_name(status);
        throw Error(status, "clEnqueueNDRangeKernel of ", name.kernel, " failed",
                    code ? ": " : "", code ? code : "");
    }
    record(stage, std::move(event));
}

void Recorder::record(cl_uint stage, Event event) {
    continue_after(std::move(event));
    context_.statistics.add_command(stage, last_command());
}

// An event of the caller's that fails after it was looked at and before the first command is
// behind it may hold that command back for ever; see waiting.hpp.
void Recorder::continue_after(Event event) {
    commands().push_back(std::move(event));
    if (commands().size() == 1)
        require_none_failed(static_cast<cl_uint>(callers_.size()), list_of(callers_));
}

// On CPUs a group is a task: single items, a few per core to balance uneven runs.
Range stream_range(const Context& context, size_t most) {
    const DeviceCaps& caps = context.caps;
    const size_t tasks = size_t{caps.compute_units} * 16;
    if (context.vector_width > 1) return {std::min(tasks, most), 1};
    return {std::min(tasks * caps.group_size, most), caps.group_size, true};
}

void Recorder::fill(cl_uint stage, cl_mem buffer, cl_uint word, size_t bytes, size_t offset) {
    if (bytes == 0 || only_notes()) return;
    const Waits waits = prepare();
    Event event;
    require_success(
        opencl(queue_).clEnqueueFillBuffer(queue_, buffer, &word, sizeof word, offset, bytes,
                                           waits.count, waits.events, event.out()),
        "clEnqueueFillBuffer");
    record(stage, std::move(event));
}

void Recorder::count(const std::function<void(rsh_statistics&)>& change) {
    if (!only_notes()) context_.statistics.add(change);
}

void Recorder::count_general_launch() {
    count([](rsh_statistics& sums) { ++sums.general_launches; });
}

void Recorder::count_later(cl_mem buffer, size_t word_count, CountRead::Use use) {
    if (only_notes()) return;
    HostRead read(queue_, buffer, word_count, prepare());
    continue_after(read.share_event());
    context_.statistics.add_read({std::move(read), std::move(use)});
}

void Recorder::own_wrong_buffers(cl_mem word) {
    wrong_buffers_ = word;
    fill(RSH_STAGE_OTHER, word, 0, sizeof(cl_uint));
}

void Recorder::write(cl_uint stage, HostWrite& from, cl_mem buffer, size_t bytes) {
    if (!only_notes()) record(stage, from.enqueue(queue_, buffer, bytes, prepare()));
}

void Recorder::flush() {
    if (only_notes() || commands().empty()) return;
    require_success(opencl(queue_).clFlush(queue_), "clFlush");
    commands().erase(commands().begin(), commands().end() - 1);
}

void Recorder::copy_word(cl_mem from, cl_mem to, size_t index) {
    if (only_notes()) return;
    const Waits waits = prepare();
    Event event;
    require_success(opencl(queue_).clEnqueueCopyBuffer(queue_, from, to, 0,
                                                       index * sizeof(cl_uint), sizeof(cl_uint),
                                                       waits.count, waits.events, event.out()),
                    "clEnqueueCopyBuffer");
    record(RSH_STAGE_OTHER, std::move(event));
}

void Recorder::wait_for_callers() {
    if (callers_.empty()) return;
    require_success(opencl(queue_).clFlush(queue_), "clFlush");
    wait_for_all(static_cast<cl_uint>(callers_.size()), list_of(callers_));
}

std::vector<cl_uint> Recorder::read_now(cl_mem buffer, size_t word_count) {
    if (only_notes()) return std::vector<cl_uint>(word_count);
    HostRead read(queue_, buffer, word_count, prepare());
    record(RSH_STAGE_OTHER, read.share_event());
    require_success(opencl(queue_).clFlush(queue_), "clFlush");
    context_.statistics.add([](rsh_statistics& sums) { ++sums.host_waits; });
    const cl_uint* const words = read.wait();
    return {words, words + word_count};
}

cl_mem Recorder::borrow_scratch(size_t bytes) {
    blocks_.reserve(blocks_.size() + 1);  // what is borrowed is given back
    blocks_.push_back(context_.pool.borrow(bytes, queue_, prepare()));
    return blocks_.back().buffer.get();
}

// The last command ends after all others. No marker behind it: PoCL 3.1 lets one wait for
// whatever the queue holds, also when it is given a wait list and the queue is out of order.
void Recorder::finish() {
    if (!done_ || last_command()) return;
    const Waits waits = prepare();
    Event event;
    require_success(opencl(queue_).clEnqueueMarkerWithWaitList(queue_, waits.count,
                                                               waits.events, event.out()),
                    "clEnqueueMarkerWithWaitList");
    continue_after(std::move(event));
}

}  // namespace rsh
