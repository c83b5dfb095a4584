#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace bench {

ProgressBar::ProgressBar(size_t steps)
    : steps_(std::max<size_t>(steps, 1)), is_visible_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (is_visible_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::begin(const std::string& step) {
    ++begun_;
    if (!is_visible_) return;
    constexpr size_t kWidth = 30;
    const size_t done = kWidth * std::min(begun_ - 1, steps_) / steps_;
    fmt::print(stderr, "\r\x1b[K[{:=<{}}{: <{}}] {} of {}: {}", "", done, "", kWidth - done,
               begun_, steps_, step);
    std::fflush(stderr);
}

}  // namespace bench
