// progress.hpp - a progress bar over frames on standard error, silent unless that is a
// terminal.
#pragma once

#include <rsh/rsh.h>

#include <string>

namespace render {

class ProgressBar {
public:
    explicit ProgressBar(int frames);
    ~ProgressBar();  // clears the line

    void begin_frame(int frame);
    // An rsh_progress; `user` is the ProgressBar. Cancels when a signal asks to end.
    static int begin_wave(cl_uint wave, cl_uint wave_count, void* user);

private:
    void draw(const std::string& step) const;

    int frames_;
    int frame_ = 0;
    bool is_visible_;
};

}  // namespace render
