// statistics_log.hpp - what the calls on a context did, while counting is switched on: events
// per stage and counts read back from the device. Adding up waits; recording and switching do
// not.
#pragma once

#include <rsh/rsh.h>

#include <functional>
#include <mutex>
#include <vector>

#include "device/objects/handle.hpp"
#include "device/objects/host_read.hpp"

namespace rsh {

// Words on their way from the device, and what they mean.
struct CountRead {
    using Use = std::function<void(rsh_statistics&, const cl_uint*)>;

    HostRead read;
    Use use;
};

// A count of 64 bits as the device makes it; see kernels/traverse/count.h.
inline cl_ulong count_of(const cl_uint* words) {
    return words[0] | cl_ulong{words[1]} << 32;
}

class StatisticsLog {
public:
    void enable(bool enabled);
    bool enabled() const;

    void add_command(cl_uint stage, cl_event event);
    // Changes the sums under the log's lock.
    void add(const std::function<void(rsh_statistics&)>& change);
    void add_read(CountRead read);

    // BLOCKS for what was recorded, without the lock: calls of other threads go on recording.
    rsh_statistics sum();

private:
    struct Command {
        cl_uint stage;
        Event event;
    };
    struct Pending {
        std::vector<Command> commands;
        std::vector<CountRead> reads;

        void wait() const noexcept;
        void add_to(rsh_statistics& sums) const;
    };
    void settle();

    mutable std::mutex mutex_;
    std::mutex settling_;  // of two threads that add up, the second needs what the first took
    bool enabled_ = false;
    unsigned period_ = 0;  // between two calls of enable()
    rsh_statistics sums_ = {};
    Pending pending_;
};

}  // namespace rsh
