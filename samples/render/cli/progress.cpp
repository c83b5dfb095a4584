// progress.cpp - draws the bar with one carriage return per step.
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "cli/interrupt.hpp"

namespace render {

ProgressBar::ProgressBar(int frames)
    : frames_(frames), is_visible_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (is_visible_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::begin_frame(int frame) {
    frame_ = frame;
    draw("");
}

int ProgressBar::begin_wave(cl_uint wave, cl_uint, void* user) {
    static_cast<const ProgressBar*>(user)->draw(fmt::format("wave {}", wave));
    return pending_signal() != 0;
}

void ProgressBar::draw(const std::string& step) const {
    if (!is_visible_) return;
    constexpr int kWidth = 40;
    const int done = kWidth * frame_ / frames_;
    fmt::print(stderr, "\r\x1b[K[{:=<{}}{: <{}}] frame {} of {} {}", "", done, "",
               kWidth - done, frame_ + 1, frames_, step);
    std::fflush(stderr);
}

}  // namespace render
