// preparer.hpp - compiles programs before a call needs them, on the calling thread or on one of the
// context's own. What fails to compile is told, and left to the call that needs it. Which programs:
// the caller knows.
#pragma once

#include <rsh/rsh.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "device/log.hpp"
#include "device/programs/needed_programs.hpp"

namespace rsh {

struct Preparation {
    NeededPrograms needed;
    rsh_progress progress;  // before each program, and after the last one; may be NULL
    void* progress_user;
    bool is_asked_for = true;  // else its failure is told to the log alone
};

class Preparer {
public:
    Preparer(Programs& programs, const Log& log) : programs_(programs), log_(log) {}
    // BLOCKS for the program that is being compiled; the rest is left out.
    ~Preparer();
    Preparer(const Preparer&) = delete;
    Preparer& operator=(const Preparer&) = delete;

    // BLOCKS for all of it, and throws the first failure.
    void prepare(const Preparation& preparation);
    // The same on the thread, behind what it has to do already.
    void start(Preparation preparation);
    // The same for a program that no call asked for: whatever fails is told to the log.
    void follow(const KernelName& name);
    // BLOCKS until the thread has nothing to do, and throws its first failure since the last time.
    void wait();

private:
    // An Error has its text in the thread that made it.
    struct Failure {
        rsh_status status = RSH_SUCCESS;
        std::string message = {};
    };
    static void keep_first(Failure& first, rsh_status status) noexcept;
    static void throw_if_failed(const Failure& failure);
    Failure compile(const Preparation& preparation) noexcept;
    void tell(const Preparation& preparation, const Failure& failure) const noexcept;
    void run() noexcept;

    Programs& programs_;
    const Log& log_;
    std::atomic<bool> is_stopped_{false};
    std::mutex mutex_;  // of all below
    std::condition_variable has_ended_;
    std::deque<Preparation> waiting_;
    Failure failure_;
    bool is_running_ = false;
    std::thread thread_;
};

}  // namespace rsh
