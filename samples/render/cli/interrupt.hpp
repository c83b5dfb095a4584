// interrupt.hpp - SIGINT, SIGTERM and SIGHUP as a wish to end, which the program follows where
// nothing is half done. A second one of the same kind ends it at once.
#pragma once

#include <stdexcept>

namespace render {

// Also makes a file that outgrows the limit of the process an error of write().
void handle_signals();

// The signal that asked to end; 0: none.
int pending_signal() noexcept;

struct Interrupted : std::runtime_error {
    explicit Interrupted(int number);
    int signal;
};

// Throws Interrupted if a signal asked to end.
void stop_if_interrupted();

}  // namespace render
