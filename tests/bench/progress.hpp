// progress.hpp - a progress bar over cases on standard error, silent unless that is a terminal.
#pragma once

#include <cstddef>
#include <string>

namespace bench {

class ProgressBar {
public:
    explicit ProgressBar(size_t steps);
    ~ProgressBar();  // clears the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void begin(const std::string& step);  // the next one

private:
    size_t steps_;
    size_t begun_ = 0;
    bool is_visible_;
};

}  // namespace bench
