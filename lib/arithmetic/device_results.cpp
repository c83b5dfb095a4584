#include "arithmetic/device_results.hpp"

#include <cstring>

#include "device/cl/recorder.hpp"
#include "device/objects/host_read.hpp"

namespace rsh {
namespace {

constexpr size_t kLongestVector = 16;

// Rows of a, b, c and d, filled up with 1.
std::vector<float> rows_of(const std::vector<Operands>& operands, size_t stride) {
    std::vector<float> rows(4 * stride, 1.0f);
    for (size_t i = 0; i < operands.size(); ++i) {
        const Operands& o = operands[i];
        const double values[] = {o.a, o.b, o.c, o.d};
        for (size_t row = 0; row < 4; ++row)
            rows[row * stride + i] = static_cast<float>(values[row]);
    }
    return rows;
}

}  // namespace

DeviceResults::DeviceResults(Context& context, cl_command_queue queue,
                             const std::vector<Operands>& operands, cl_uint lanes)
    : lanes_(lanes),
      stride_((operands.size() + kLongestVector - 1) / kLongestVector * kLongestVector) {
    const std::vector<float> rows = rows_of(operands, stride_);
    const size_t word_count = RSH_PROBE_ROWS * stride_;
    const Buffer input = new_buffer(context.cl.get(), CL_MEM_READ_WRITE,
                                    rows.size() * sizeof rows[0], rows.data());
    const Buffer results =
        new_buffer(context.cl.get(), CL_MEM_READ_WRITE, word_count * sizeof(cl_uint));
    Recorder recorder(context, {queue, 0, nullptr}, nullptr);
    recorder.launch(RSH_STAGE_OTHER,
                    {"arithmetic/probe", lanes == 1 ? "rsh_probe" : "rsh_probe_lanes"},
                    recorder.range(stride_ / lanes), input.get(), static_cast<cl_uint>(stride_),
                    results.get());
    require_success(opencl(queue).clFinish(queue), "clFinish");
    const HostRead read(queue, results.get(), word_count, {0, nullptr});
    const cl_uint* const words = read.wait();
    words_.assign(words, words + word_count);
}

cl_int DeviceResults::as_int(probe_row row, size_t index) const {
    return static_cast<cl_int>(words_[row * stride_ + index]);
}

float DeviceResults::as_float(probe_row row, size_t index) const {
    float value = 0;
    std::memcpy(&value, &words_[row * stride_ + index], sizeof value);
    return value;
}

}  // namespace rsh
