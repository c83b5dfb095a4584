// cub_race.cuh - a stream of the pattern "random" in the memory of a CUDA device, reduced by CUB's
// DeviceSelect::If, in turn with a copy of the same bytes. Checked before it is timed. Knows no
// command line and no JSON.
#pragma once

#include <cuda_runtime.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <cub/device/device_select.cuh>
#include <functional>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

constexpr uint32_t kNull = 0xffffffffu;  // the first word of what is dropped

inline void require(cudaError_t status, const std::string& call) {
    if (status != cudaSuccess)
        throw std::runtime_error(call + ": " + cudaGetErrorString(status));
}

// Memory of the device, freed at the end.
class DeviceMemory {
public:
    explicit DeviceMemory(size_t bytes) { require(cudaMalloc(&memory_, bytes), "cudaMalloc"); }
    ~DeviceMemory() { cudaFree(memory_); }
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;
    template <class T>
    T* as() const {
        return static_cast<T*>(memory_);
    }

private:
    void* memory_ = nullptr;
};

__host__ __device__ inline uint32_t first_word(uint32_t element) {
    return element;
}
__host__ __device__ inline uint32_t first_word(uint2 element) {
    return element.x;
}

struct IsNotNull {
    template <class T>
    __host__ __device__ bool operator()(const T& element) const {
        return first_word(element) != kNull;
    }
};

inline void make(uint32_t index, bool is_kept, uint32_t& element) {
    element = is_kept ? index : kNull;
}
inline void make(uint32_t index, bool is_kept, uint2& element) {
    element = {is_kept ? index : kNull, index + 0x10001u};
}

// The stream of patterns.cpp and stream.cpp: each part of 2^20 elements has a generator of its own.
template <class T>
std::vector<T> random_stream(uint32_t count, uint32_t keep_percent) {
    constexpr uint32_t kPart = 1u << 20;
    std::mt19937 random;
    std::vector<T> stream(count);
    for (uint32_t i = 0; i < count; ++i) {
        if (i % kPart == 0) random.seed(count + keep_percent + i / kPart);
        make(i, random() % 100 < keep_percent, stream[i]);
    }
    return stream;
}

struct Times {
    std::vector<double> host, device;  // milliseconds
};

class Stopwatch {
public:
    Stopwatch() {
        require(cudaEventCreate(&begin_), "cudaEventCreate");
        require(cudaEventCreate(&end_), "cudaEventCreate");
    }
    ~Stopwatch() {
        cudaEventDestroy(begin_);
        cudaEventDestroy(end_);
    }
    void time(const std::function<void()>& enqueue, Times& times) {
        const auto start = std::chrono::steady_clock::now();
        require(cudaEventRecord(begin_), "cudaEventRecord");
        enqueue();
        require(cudaEventRecord(end_), "cudaEventRecord");
        require(cudaEventSynchronize(end_), "cudaEventSynchronize");
        const std::chrono::duration<double, std::milli> passed =
            std::chrono::steady_clock::now() - start;
        float ms = 0;
        require(cudaEventElapsedTime(&ms, begin_, end_), "cudaEventElapsedTime");
        times.host.push_back(passed.count());
        times.device.push_back(ms);
    }

private:
    cudaEvent_t begin_, end_;
};

struct Result {
    bool is_right = false;
    uint64_t kept = 0;
    Times copy, select;
};

// A stream on the device, and CUB's way to reduce it.
template <class T>
class Race {
public:
    Race(uint32_t count, uint32_t keep)
        : stream_(random_stream<T>(count, keep)),
          input_(bytes()),
          output_(bytes()),
          copied_(bytes()),
          kept_(sizeof(uint32_t)),
          scratch_bytes_(scratch_bytes()),
          scratch_(scratch_bytes_) {
        require(cudaMemcpy(input_.as<T>(), stream_.data(), bytes(), cudaMemcpyHostToDevice),
                "cudaMemcpy");
    }

    Result run(double budget_ms) {
        Result result;
        result.is_right = is_right(result.kept);
        if (!result.is_right) return result;
        Stopwatch watch;
        Times first;
        const auto copying = [&] { copy(); };
        const auto selecting = [&] { select(scratch_.as<void>(), scratch_bytes_); };
        watch.time(copying, first);
        watch.time(selecting, first);
        double used = 0;
        while (result.select.host.size() < 3 ||
               (result.select.host.size() < 200 && used < budget_ms)) {
            watch.time(copying, result.copy);
            watch.time(selecting, result.select);
            used += result.copy.host.back() + result.select.host.back();
        }
        return result;
    }

private:
    size_t bytes() const { return stream_.size() * sizeof(T); }

    void copy() {
        require(
            cudaMemcpyAsync(copied_.as<T>(), input_.as<T>(), bytes(), cudaMemcpyDeviceToDevice),
            "cudaMemcpyAsync");
    }
    // Without scratch memory: says how much it needs.
    void select(void* scratch, size_t& bytes) {
        require(cub::DeviceSelect::If(scratch, bytes, input_.as<T>(), output_.as<T>(),
                                      kept_.as<uint32_t>(), int(stream_.size()), IsNotNull{}),
                "cub::DeviceSelect::If");
    }
    size_t scratch_bytes() {
        size_t needed = 0;
        select(nullptr, needed);
        return std::max<size_t>(needed, 1);
    }

    bool is_right(uint64_t& kept) {
        require(cudaMemset(output_.as<T>(), 0xcd, bytes()), "cudaMemset");
        require(cudaMemset(kept_.as<uint32_t>(), 0xcd, sizeof(uint32_t)), "cudaMemset");
        select(scratch_.as<void>(), scratch_bytes_);
        uint32_t found = 0;
        require(cudaMemcpy(&found, kept_.as<uint32_t>(), sizeof found, cudaMemcpyDeviceToHost),
                "cudaMemcpy");
        std::vector<T> output(stream_.size()), answer;
        std::copy_if(stream_.begin(), stream_.end(), std::back_inserter(answer), IsNotNull{});
        require(cudaMemcpy(output.data(), output_.as<T>(), bytes(), cudaMemcpyDeviceToHost),
                "cudaMemcpy");
        kept = answer.size();
        return found == kept &&
               std::memcmp(answer.data(), output.data(), kept * sizeof(T)) == 0;
    }

    std::vector<T> stream_;
    DeviceMemory input_, output_, copied_, kept_;
    size_t scratch_bytes_;
    DeviceMemory scratch_;
};
