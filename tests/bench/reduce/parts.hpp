// parts.hpp - work on a long stream by all cores of the host. Parts are the same on every machine,
// whatever the number of its cores.
#pragma once

#include <rsh/rsh.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace bench {

struct Part {
    size_t index;
    cl_uint begin, end;
};

constexpr cl_uint kPartLength = 1u << 20;

inline size_t part_count(cl_uint count) {
    return (size_t{count} + kPartLength - 1) / kPartLength;
}

// Calls work(part) for each part, in any order and from several threads. It must not throw.
template <class Work>
void for_parts(cl_uint count, const Work& work) {
    const size_t parts = part_count(count);
    std::atomic<size_t> next{0};
    const auto take = [&] {
        for (size_t i = next++; i < parts; i = next++) {
            const size_t begin = i * kPartLength;
            work(
                Part{i, cl_uint(begin), cl_uint(std::min<size_t>(begin + kPartLength, count))});
        }
    };
    std::vector<std::thread> threads(
        std::min<size_t>(std::max(1u, std::thread::hardware_concurrency()), parts));
    for (size_t i = 1; i < threads.size(); ++i) threads[i] = std::thread(take);
    take();
    for (std::thread& thread : threads)
        if (thread.joinable()) thread.join();
}

}  // namespace bench
