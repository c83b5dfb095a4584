// log.hpp - lines for the caller's log, when there is one.
#pragma once

#include <rsh/rsh.h>

#include <string>

namespace rsh {

class Log {
public:
    Log(rsh_log call, void* user) : call_(call), user_(user) {}

    void operator()(const std::string& line) const {
        if (call_) call_(line.c_str(), user_);
    }

private:
    rsh_log call_;
    void* user_;
};

}  // namespace rsh
