#include "budgets/search.hpp"

#include <numeric>
#include <stdexcept>

namespace bench::budgets {
namespace {

constexpr size_t kItems = 1024;
constexpr cl_uint kSteps = 512;       // evaluations of a work-item between generations
constexpr int kRoundsForNothing = 8;  // after which a bound is said never to apply

template <class T>
cl::Buffer buffer_of(const Device& device, const std::vector<T>& values) {
    return cl::Buffer(device.context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
                      values.size() * sizeof(T), const_cast<T*>(values.data()));
}

template <class T>
void write(const Device& device, const cl::Buffer& buffer, const std::vector<T>& values) {
    device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(T),
                                      values.data());
}

template <class T>
void read(const Device& device, const cl::Buffer& buffer, std::vector<T>& values) {
    device.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(T),
                                     values.data());
}

}  // namespace

Worst search(const Device& device, cl::Kernel& kernel, size_t width, uint64_t evaluations) {
    Population population(kItems, width);
    std::vector<cl_uint> evaluated(kItems);
    const cl::Buffer worst = buffer_of(device, population.worst);
    const cl::Buffer inputs = buffer_of(device, population.inputs);
    const cl::Buffer counts = buffer_of(device, evaluated);
    kernel.setArg(1, kSteps);
    kernel.setArg(2, worst);
    kernel.setArg(3, inputs);
    kernel.setArg(4, counts);
    Worst found;
    for (cl_uint round = 1; found.evaluations < evaluations; ++round) {
        write(device, worst, population.worst);
        write(device, inputs, population.inputs);
        kernel.setArg(0, round * 0x9e3779b9u);
        device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(kItems));
        read(device, worst, population.worst);
        read(device, inputs, population.inputs);
        read(device, counts, evaluated);
        found.evaluations += std::accumulate(evaluated.begin(), evaluated.end(), uint64_t{0});
        if (found.evaluations == 0 && round == kRoundsForNothing)
            throw std::runtime_error("the bound applied to no input");
        const size_t best = population.largest();
        if (population.worst[best] > found.error) {
            found.error = population.worst[best];
            const auto from = population.inputs.begin() + std::ptrdiff_t(best * width);
            found.input.assign(from, from + std::ptrdiff_t(width));
        }
        population.breed();
    }
    return found;
}

}  // namespace bench::budgets
