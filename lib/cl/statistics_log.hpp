// statistics_log.hpp - what the calls on a context did, while counting is switched on: events per
// stage and counts read back from the device. Adding up waits; recording does not.
#pragma once

#include <rsh/rsh.h>

#include <deque>
#include <functional>
#include <mutex>
#include <vector>

#include "cl/opencl.hpp"

namespace rsh {

class StatisticsLog {
public:
    void enable(bool enabled);
    bool enabled() const;

    void add_command(cl_uint stage, const cl::Event& event);
    // Changes the sums under the log's lock.
    void add(const std::function<void(rsh_statistics&)>& change);

    // Host memory that a non-blocking read may fill until `event`; then `use` adds it to the sums.
    cl_uint* expect_counts(size_t count, std::function<void(rsh_statistics&, const cl_uint*)> use);
    void add_pending(const cl::Event& event);

    rsh_statistics sum();  // blocks

private:
    struct Pending {
        std::vector<cl_uint> counts;
        std::function<void(rsh_statistics&, const cl_uint*)> use;
    };
    struct Command {
        cl_uint stage;
        cl::Event event;
    };
    void settle();

    mutable std::mutex mutex_;
    bool enabled_ = false;
    rsh_statistics sums_ = {};
    std::vector<Command> commands_;
    std::vector<cl::Event> reads_;
    std::deque<Pending> pending_;  // stable addresses
};

}  // namespace rsh
