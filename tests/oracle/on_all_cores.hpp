// on_all_cores.hpp - the same work on every core of the machine; whoever comes takes the next part.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace oracle {

// work(i) for 0 <= i < count, by whichever thread is free. Must not throw.
template <class Work>
void on_all_cores(size_t count, const Work& work) {
    std::atomic<size_t> next{0};
    const auto take = [&] {
        for (size_t i; (i = next.fetch_add(1)) < count;) work(i);
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
        threads.emplace_back(take);
    take();
    for (std::thread& thread : threads) thread.join();
}

}  // namespace oracle
