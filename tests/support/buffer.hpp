// buffer.hpp - device arrays that never start zeroed and notice a write outside of them.
//
// The array is a sub-buffer of exactly its size, with a guard on either side. RSH_TEST_SMALL
// means Oclgrind, which sees accesses outside of a buffer, reads too: there it has no guards.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "support/device.hpp"
#include "support/random.hpp"

namespace test {

constexpr uint8_t kCanary = 0xa5;

class Bytes {
public:
    explicit Bytes(size_t bytes, const void* data = nullptr);

    cl_mem get() const { return array_(); }
    size_t bytes() const { return bytes_; }
    void write(const void* data, size_t bytes) const;
    void read(void* data, size_t bytes) const;
    ::testing::AssertionResult guards_intact() const;

private:
    size_t guard_;
    size_t bytes_;
    cl::Buffer whole_;
    cl::Buffer array_;
};

template <class T>
class Buffer {
public:
    explicit Buffer(size_t count) : count_(count), bytes_(count * sizeof(T)) {}
    explicit Buffer(const std::vector<T>& data)
        : count_(data.size()), bytes_(count_ * sizeof(T), data.data()) {}

    cl_mem get() const { return bytes_.get(); }
    size_t count() const { return count_; }
    void write(const std::vector<T>& data) const {
        bytes_.write(data.data(), count_ * sizeof(T));
    }
    ::testing::AssertionResult guards_intact() const { return bytes_.guards_intact(); }

    std::vector<T> read() const {
        std::vector<T> data(count_);
        bytes_.read(data.data(), count_ * sizeof(T));
        return data;
    }

    // Nothing was written: every byte still is the canary.
    ::testing::AssertionResult untouched() const {
        std::vector<uint8_t> data(count_ * sizeof(T));
        bytes_.read(data.data(), data.size());
        const auto wrong = std::find_if(data.begin(), data.end(),
                                        [](uint8_t byte) { return byte != kCanary; });
        if (wrong == data.end()) return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure()
               << "byte " << (wrong - data.begin()) << " was written: " << int(*wrong);
    }

private:
    size_t count_;
    Bytes bytes_;
};

}  // namespace test
