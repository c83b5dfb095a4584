#include "ablation/work.hpp"

namespace bench::ablation {

cl::Buffer Work::buffer(size_t bytes) {
    if (bytes == 0) return cl::Buffer();
    bytes_ += bytes;
    return cl::Buffer(device_.context(), CL_MEM_READ_WRITE, bytes);
}

void Work::append(const cl::Buffer& from, size_t bytes, std::vector<uint8_t>& to) const {
    if (bytes == 0) return;
    const size_t begin = to.size();
    to.resize(begin + bytes);
    queue_.enqueueReadBuffer(from, CL_TRUE, 0, bytes, to.data() + begin);
}

}  // namespace bench::ablation
