// under_way.hpp - the events of calls that have not ended. PoCL 3.1 ends the process when a command
// fails whose event nobody holds (pocl_update_event_failed goes back to what it has freed), as all
// behind an event of the caller's do that fails; so they are held until a later call finds them
// complete, or failed a good while ago: that they failed is seen while PoCL still is in there.
#pragma once

#include <chrono>
#include <list>
#include <mutex>
#include <vector>

#include "device/objects/handle.hpp"

namespace rsh {

class UnderWay {
public:
    struct Call {
        std::vector<Event> commands;  // in their order: the last one ends last
        std::chrono::steady_clock::time_point failed = {};
    };
    // A list of one call is what is kept, as that takes no memory.
    using Calls = std::list<Call>;

    void keep(Calls call) noexcept;

private:
    static bool is_done_with(Call& call) noexcept;

    std::mutex mutex_;
    Calls calls_;
};

}  // namespace rsh
