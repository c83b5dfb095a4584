// counts.hpp - what the layer of counts.cpp has counted of a process's OpenCL calls. In the process
// dlsym finds rsh_read_counts in the layer; from outside, the file that RSH_COUNTS names has the
// same words as JSON, written when the process ends. rsh_restart_peak lets bytes_peak begin anew, from
// bytes_alive.
#pragma once

#include <cstddef>

/* Made: buffers, sub-buffers, kernels. compiles: builds, compilations and links; binary_builds: all of
 * binaries. waits of the host: finish, wait for events, blocking reads, writes and maps. copies:
 * enqueued, reads and writes, too. bytes: of buffers. */
#define RSH_COUNTS(WORD)    \
    WORD(buffers)           \
    WORD(sub_buffers)       \
    WORD(compiles)          \
    WORD(binary_builds)     \
    WORD(kernels)           \
    WORD(waits)             \
    WORD(launches)          \
    WORD(fills)             \
    WORD(copies)            \
    WORD(bytes_alive)       \
    WORD(bytes_peak)        \
    WORD(buffers_alive)     \
    WORD(sub_buffers_alive) \
    WORD(programs_alive)    \
    WORD(kernels_alive) WORD(contexts_alive) WORD(queues_alive) WORD(events_alive)

struct rsh_counts {
#define RSH_MEMBER(name) size_t name;
    RSH_COUNTS(RSH_MEMBER)
#undef RSH_MEMBER
};

typedef void (*rsh_read_counts_function)(struct rsh_counts* counts);
typedef void (*rsh_restart_peak_function)();
