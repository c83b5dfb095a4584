// file_proxy.cpp - writes at places; the first failure is kept, and nothing is written after it.
#include "picture/file_proxy.hpp"

#include <algorithm>

namespace render {

FileProxy::FileProxy(WholeFile& file) : IOProxy("picture", Write), file_(file) {}

size_t FileProxy::write(const void* bytes, size_t count) {
    const size_t written = pwrite(bytes, count, m_pos);
    m_pos += static_cast<int64_t>(written);
    return written;
}

size_t FileProxy::pwrite(const void* bytes, size_t count, int64_t offset) {
    if (error_) return 0;
    try {
        put(static_cast<const char*>(bytes), count, static_cast<size_t>(offset));
    } catch (...) {
        error_ = std::current_exception();
        return 0;
    }
    size_ = std::max(size_, static_cast<size_t>(offset) + count);
    return count;
}

void FileProxy::put(const char* bytes, size_t count, size_t offset) {
    if (!file_.is_stream()) return file_.write_at(offset, {bytes, count});
    memory_.resize(std::max(memory_.size(), offset + count));
    std::copy_n(bytes, count, memory_.begin() + static_cast<std::ptrdiff_t>(offset));
}

void FileProxy::require_written() const {
    if (error_) std::rethrow_exception(error_);
}

void FileProxy::finish() {
    require_written();
    if (file_.is_stream()) file_.write(memory_);
}

}  // namespace render
