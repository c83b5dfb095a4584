// interrupt.cpp - a handler that only takes a note.
#include "cli/interrupt.hpp"

#include <csignal>
#include <cstring>
#include <string>

namespace render {
namespace {

volatile std::sig_atomic_t g_signal = 0;

extern "C" void note_signal(int number) {
    g_signal = number;
}

}  // namespace

void handle_signals() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    // Calls go on after it; the next one of its kind finds the default, which ends the program.
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        sigaction(number, nullptr, &before);
        // nohup, and shells that start a job in the background, have it ignored.
        if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

int pending_signal() noexcept {
    return g_signal;
}

Interrupted::Interrupted(int number)
    : std::runtime_error(std::string("interrupted (") + strsignal(number) + ")"),
      signal(number) {}

void stop_if_interrupted() {
    if (const int number = pending_signal()) throw Interrupted(number);
}

}  // namespace render
