// copy_contender.cpp - the limit: copying the input, by clEnqueueCopyBuffer, by a kernel and by a
// kernel that stores past the caches; and an empty launch.
#include <algorithm>
#include <stdexcept>

#include "reduce/contender.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr char kSource[] = R"(
__kernel void copy(__global const uint4* from, __global uint4* to)
{
    to[get_global_id(0)] = from[get_global_id(0)];
}

#ifdef __has_builtin
#if __has_builtin(__builtin_nontemporal_store)
#define STORE(value, to) __builtin_nontemporal_store(value, to)
#endif
#endif
#ifndef STORE
#define STORE(value, to) (*(to) = (value))
#endif

__kernel void stream(__global const uint16* from, __global uint16* to, uint count)
{
    const uint run = (count + get_global_size(0) - 1) / get_global_size(0);
    const uint begin = min(run * (uint)get_global_id(0), count);
    const uint end = min(begin + run, count);
    for (uint i = begin; i < end; ++i) STORE(from[i], to + i);
}

__kernel void empty(__global uint* to)
{
    if (get_global_id(0) == 0xffffffffu) *to = 0;
}
)";

// The kernels copy whole vectors only: up to 60 bytes fewer than the stream has.
class Copy : public Contender {
public:
    Copy(const std::string& name, const Device& device, const DeviceStream& stream,
         const cl::Buffer& to)
        : device_(device),
          stream_(stream),
          to_(to),
          bytes_(stream.host.bytes()),
          is_empty_(name == "peer:empty_launch") {
        if (name == "peer:copy_buffer") return;
        cl::Program program(device.context(), std::string(kSource));
        program.build({device.device()}, "-cl-std=CL1.2");
        const char* kernel = name == "peer:copy_kernel"   ? "copy"
                             : name == "peer:copy_stream" ? "stream"
                             : name == "peer:empty_launch"
                                 ? "empty"
                                 : throw std::runtime_error("no contender " + name);
        kernel_ = cl::Kernel(program, kernel);
        set_arguments(kernel);
    }

    void run() override {
        if (!kernel_())
            device_.queue().enqueueCopyBuffer(stream_.input, to_, 0, 0, bytes_);
        else
            device_.queue().enqueueNDRangeKernel(kernel_, cl::NullRange, items_, group_);
        device_.queue().finish();
    }
    bool is_right() const override {
        if (is_empty_) return true;
        const size_t words = bytes_ / 64 * 16;
        if (words == 0) return true;
        stream_.read.resize(words);
        device_.queue().enqueueReadBuffer(to_, CL_TRUE, 0, words * sizeof(cl_uint),
                                          stream_.read.data());
        return std::equal(stream_.read.begin(), stream_.read.end(), stream_.host.words.begin());
    }
    cl_ulong launches() const override { return 1; }

private:
    void set_arguments(const std::string& kernel) {
        const cl_uint units = device_.device().getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
        if (kernel == "empty") {
            kernel_.setArg(0, to_);
            items_ = group_ = cl::NDRange(1);
            return;
        }
        kernel_.setArg(0, stream_.input);
        kernel_.setArg(1, to_);
        if (kernel == "stream") {
            kernel_.setArg(2, cl_uint(bytes_ / 64));
            items_ = cl::NDRange(units * 16);
            group_ = cl::NDRange(1);
            return;
        }
        const size_t vectors = bytes_ / 16;
        size_t group = 256;
        while (group > 1 && vectors % group != 0) group /= 2;
        items_ = cl::NDRange(vectors);
        group_ = cl::NDRange(group);
    }

    const Device& device_;
    const DeviceStream& stream_;
    cl::Buffer to_;
    size_t bytes_;
    bool is_empty_;
    cl::Kernel kernel_;
    cl::NDRange items_, group_;
};

// The better quartile of a series on its own: a copy by one core lets the others fall asleep,
// which a kernel in turn with it would have to pay for.
double steady_ms(Contender& copy) {
    std::vector<double> times;
    for (int i = 0; i < 25; ++i) times.push_back(milliseconds([&] { copy.run(); }));
    return spread(times).low;
}

std::unique_ptr<Contender> quicker_copy(const Device& device, const DeviceStream& stream,
                                        const cl::Buffer& to) {
    auto buffer = std::make_unique<Copy>("peer:copy_buffer", device, stream, to);
    auto kernel = std::make_unique<Copy>("peer:copy_kernel", device, stream, to);
    const double kernel_ms = steady_ms(*kernel);
    return kernel_ms < steady_ms(*buffer) ? std::move(kernel) : std::move(buffer);
}

}  // namespace

std::unique_ptr<Contender> make_copy(const std::string& name, const Device& device,
                                     const DeviceStream& stream, const cl::Buffer& to) {
    if (name == "peer:copy") return quicker_copy(device, stream, to);
    return std::make_unique<Copy>(name, device, stream, to);
}

}  // namespace bench
