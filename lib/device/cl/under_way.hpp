// under_way.hpp - the events of calls that have not ended. PoCL 3.1 ends the process when a command
// fails whose event nobody holds (pocl_update_event_failed unlocks what it has freed), as all behind
// an event of the caller's do that fails; so they are held until a later call finds them ended.
#pragma once

#include <list>
#include <mutex>
#include <vector>

#include "device/objects/handle.hpp"

namespace rsh {

class UnderWay {
public:
    // Of one call, in their order: the last one ends last. A list of one, so that to keep it takes
    // no memory.
    using Calls = std::list<std::vector<Event>>;

    // Drops those of calls that ended.
    void keep(Calls call) noexcept;

private:
    std::mutex mutex_;
    Calls calls_;
};

}  // namespace rsh
