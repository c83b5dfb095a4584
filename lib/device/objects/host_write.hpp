// host_write.hpp - memory that the host fills and commands copy from. It is never freed while a device may
// still read it: where its last command can neither be waited for nor tell when it ends, it is given up.
#pragma once

#include <cstddef>
#include <memory>

#include "device/objects/handle.hpp"

namespace rsh {

class HostWrite {
public:
    explicit HostWrite(size_t bytes);
    // With a command under way, it leaves the memory to a callback of the command's.
    ~HostWrite();
    HostWrite(HostWrite&&) noexcept = default;
    HostWrite& operator=(HostWrite&&) = delete;

    // Whether a command may still read it.
    bool is_under_way() const noexcept;
    // To be filled. BLOCKS until the last command has read it; throws when that failed, or cannot be known.
    void* filled_anew();
    // Enqueues a copy of its front to that of `buffer`, after `waits`. Returns the command.
    Event enqueue(cl_command_queue queue, cl_mem buffer, size_t bytes, const Waits& waits);

private:
    std::unique_ptr<char[]> memory_;
    Event event_;
    cl_int given_up_ = CL_SUCCESS;  // why
};

}  // namespace rsh
