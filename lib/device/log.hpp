// log.hpp - lines for the caller's log, when there is one.
#pragma once

#include <rsh/rsh.h>

#include "device/text.hpp"

namespace rsh {

class Log {
public:
    Log(rsh_log call, void* user) : call_(call), user_(user) {}

    // The parts of a line: strings, characters, numbers. Takes no memory.
    template <class... Parts>
    void operator()(const Parts&... parts) const {
        if (!call_) return;
        char line[2048];
        Text(line, sizeof line).add(parts...);
        call_(line, user_);
    }

private:
    rsh_log call_;
    void* user_;
};

}  // namespace rsh
