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

#include "device/programs/needed_programs.hpp"

namespace rsh {

struct Preparation {
    NeededPrograms needed;
    rsh_progress progress;  // before each program, and after the last one; may be NULL
    void* progress_user;
};

class Preparer {
public:
    explicit Preparer(Programs& programs) : programs_(programs) {}
    // BLOCKS for the program that is being compiled; the rest is left out.
    ~Preparer();
    Preparer(const Preparer&) = delete;
    Preparer& operator=(const Preparer&) = delete;

    // BLOCKS for all of it, and throws the first failure.
    void prepare(const Preparation& preparation);
    // The same on the thread, behind what it has to do already.
    void start(Preparation preparation);
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
    void run() noexcept;

    Programs& programs_;
    std::atomic<bool> is_stopped_{false};
    std::mutex mutex_;  // of all below
    std::condition_variable has_ended_;
    std::deque<Preparation> waiting_;
    Failure failure_;
    bool is_running_ = false;
    std::thread thread_;
};

}  // namespace rsh
