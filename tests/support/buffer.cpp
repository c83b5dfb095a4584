// buffer.cpp - guards, reading and writing; everything blocks, on the device's own queue.
#include "support/buffer.hpp"

namespace test {
namespace {

// At least the alignment that sub-buffers need.
size_t guard_bytes() {
    if (small()) return 0;
    const size_t align = device().device.getInfo<CL_DEVICE_MEM_BASE_ADDR_ALIGN>() / 8;
    return std::max<size_t>(1024, align);
}

}  // namespace

// A buffer of no bytes does not exist in OpenCL; four bytes stand in for it.
Bytes::Bytes(size_t bytes, const void* data)
    : guard_(guard_bytes()), bytes_(std::max<size_t>(bytes, 4)) {
    std::vector<uint8_t> start(bytes_ + 2 * guard_, kCanary);
    if (data && bytes) std::memcpy(start.data() + guard_, data, bytes);
    whole_ = cl::Buffer(device().context, CL_MEM_READ_WRITE, start.size());
    device().queue.enqueueWriteBuffer(whole_, CL_TRUE, 0, start.size(), start.data());
    cl_buffer_region region = {guard_, bytes_};
    array_ = guard_ ? whole_.createSubBuffer(CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION,
                                             &region)
                    : whole_;
}

void Bytes::write(const void* data, size_t bytes) const {
    if (bytes) device().queue.enqueueWriteBuffer(whole_, CL_TRUE, guard_, bytes, data);
}

void Bytes::read(void* data, size_t bytes) const {
    if (bytes) device().queue.enqueueReadBuffer(whole_, CL_TRUE, guard_, bytes, data);
}

::testing::AssertionResult Bytes::guards_intact() const {
    std::vector<uint8_t> all(bytes_ + 2 * guard_);
    device().queue.enqueueReadBuffer(whole_, CL_TRUE, 0, all.size(), all.data());
    for (size_t i = 0; i < all.size(); ++i) {
        const bool inside = i >= guard_ && i < guard_ + bytes_;
        if (!inside && all[i] != kCanary)
            return ::testing::AssertionFailure()
                   << "byte " << (long long)(i) - (long long)(guard_) << " of a buffer of "
                   << bytes_ << " bytes was written";
    }
    return ::testing::AssertionSuccess();
}

}  // namespace test
