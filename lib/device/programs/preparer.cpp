#include "device/programs/preparer.hpp"

#include <new>
#include <string_view>
#include <system_error>

#include "device/error.hpp"

namespace rsh {

Preparer::~Preparer() {
    is_stopped_ = true;
    if (thread_.joinable()) thread_.join();
}

void Preparer::prepare(const Preparation& preparation) {
    throw_if_failed(compile(preparation));
}

// A thread that has ended is joined without the wait for anything.
void Preparer::start(Preparation preparation) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.push_back(std::move(preparation));
    if (is_running_) return;
    if (thread_.joinable()) thread_.join();
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error& error) {
        waiting_.pop_back();
        throw Error(RSH_OUT_OF_MEMORY, "background: no thread can be started: ", error.what());
    } catch (...) {
        waiting_.pop_back();
        throw;
    }
    is_running_ = true;
}

void Preparer::follow(const KernelName& name) {
    Preparation preparation = {{}, nullptr, nullptr, false};
    preparation.needed.add(name);
    const rsh_status status = guarded([&] { start(preparation); });
    if (status != RSH_SUCCESS) tell(preparation, {status, last_error()});
}

void Preparer::wait() {
    Failure failure;
    {
        std::unique_lock<std::mutex> lock(mutex_);
        has_ended_.wait(lock, [this] { return !is_running_; });
        std::swap(failure, failure_);
    }
    throw_if_failed(failure);
}

// Where there is no memory for the text, that is the failure, whose text needs none.
void Preparer::keep_first(Failure& first, rsh_status status) noexcept {
    if (status == RSH_SUCCESS || first.status != RSH_SUCCESS) return;
    first.status = status;
    try {
        first.message = last_error();
    } catch (const std::bad_alloc&) {
        first.status = RSH_OUT_OF_MEMORY;
    }
}

void Preparer::throw_if_failed(const Failure& failure) {
    if (failure.status == RSH_OUT_OF_MEMORY && failure.message.empty()) throw std::bad_alloc();
    if (failure.status != RSH_SUCCESS) throw Error(failure.status, failure.message);
}

Preparer::Failure Preparer::compile(const Preparation& preparation) noexcept {
    const std::vector<KernelName>& kernels = preparation.needed.kernels();
    const auto count = static_cast<cl_uint>(kernels.size());
    const auto report = [&](cl_uint done) {
        if (preparation.progress &&
            preparation.progress(done, count, preparation.progress_user))
            throw Error(RSH_CANCELLED, "progress: asked to stop after ", done, " of ", count,
                        " programs");
    };
    Failure first;
    for (cl_uint i = 0; i < count && !is_stopped_; ++i) {
        const rsh_status asked = guarded([&] { report(i); });
        keep_first(first, asked);
        if (asked != RSH_SUCCESS) return first;
        keep_first(first, guarded([&] { programs_.borrow(kernels[i]); }));
    }
    if (!is_stopped_) keep_first(first, guarded([&] { report(count); }));
    return first;
}

// The first line of the failure: what a compiler says may have many.
void Preparer::tell(const Preparation& preparation, const Failure& failure) const noexcept {
    const std::string_view message = failure.message;
    guarded([&] {
        log_(preparation.needed.kernels().front().program,
             ".cl: a general program goes on to serve, as a variant fails: ",
             message.substr(0, message.find('\n')));
    });
}

void Preparer::run() noexcept {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!waiting_.empty() && !is_stopped_) {
        const Preparation next = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        Failure failure = compile(next);
        if (!next.is_asked_for && failure.status != RSH_SUCCESS) tell(next, failure);
        lock.lock();
        if (next.is_asked_for && failure_.status == RSH_SUCCESS) failure_ = std::move(failure);
    }
    is_running_ = false;
    has_ended_.notify_all();
}

}  // namespace rsh
