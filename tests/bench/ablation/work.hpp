// work.hpp - calls of the library with one choice of features, and buffers of their own that are made once.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "device.hpp"

namespace bench::ablation {

class Work {
public:
    explicit Work(const Device& device) : device_(device), queue_(device.queue()) {}
    virtual ~Work() = default;
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    // With a context whose device is that of the constructor. BLOCKS until all is done.
    virtual void run(rsh_context context) = 0;
    // What runs need, by rsh_prepare.
    virtual void prepare(rsh_context context) const = 0;
    // All outputs of the last run.
    virtual std::vector<uint8_t> answer() const = 0;
    // Whether the last run's answer is that of brute force, bit for bit, in a sample of it.
    virtual bool is_right(rsh_context context) const = 0;
    // Which programs a run needs: works of one kind that need the same ones have the same words.
    virtual std::string programs() const = 0;

    size_t bytes() const { return bytes_; }  // of all buffers

protected:
    template <class T>
    cl::Buffer upload(const std::vector<T>& items) {
        if (items.empty()) return cl::Buffer();
        const cl::Buffer made = buffer(items.size() * sizeof(T));
        queue_.enqueueWriteBuffer(made, CL_TRUE, 0, items.size() * sizeof(T), items.data());
        return made;
    }
    cl::Buffer buffer(size_t bytes);  // none for 0 bytes
    void append(const cl::Buffer& from, size_t bytes, std::vector<uint8_t>& to) const;

    template <class Query, class Desc>
    cl::Buffer scratch_of(Query query, const Desc& desc) {
        rsh_sizes sizes = rsh::make<rsh_sizes>();
        rsh::check(query(device_.rsh(), &desc, &sizes), "the query of scratch");
        return buffer(sizes.scratch_bytes);
    }

    const Device& device_;
    cl::CommandQueue queue_;

private:
    size_t bytes_ = 0;
};

}  // namespace bench::ablation
