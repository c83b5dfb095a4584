// buffers.hpp - the buffers of one call: each is of the context and holds enough, and what the
// call writes overlaps nothing else that it reads or writes.
#pragma once

#include <vector>

#include "device/cl/context.hpp"
#include "device/cl/span.hpp"

namespace rsh {

class Buffers {
public:
    explicit Buffers(const Context& context) : context_(context) {}

    // The call reads, or writes, `bytes` of the buffer; it may be NULL only if `bytes` is 0.
    void in(const char* field, cl_mem buffer, cl_ulong bytes, cl_ulong offset = 0);
    void out(const char* field, cl_mem buffer, cl_ulong bytes);
    // The same, where NULL means that there is none.
    void optional_in(const char* field, cl_mem buffer, cl_ulong bytes, cl_ulong offset = 0);
    void optional_out(const char* field, cl_mem buffer, cl_ulong bytes);
    // The same, where NULL means the pool.
    void scratch(cl_mem buffer, size_t bytes);

private:
    struct Use {
        const char* field;
        cl_mem root;
        cl_ulong begin, end;  // bytes of the root
        bool is_written;
    };
    void add(const char* field, cl_mem buffer, cl_ulong offset, cl_ulong bytes,
             bool is_written);

    const Context& context_;
    std::vector<Use> uses_;
};

}  // namespace rsh
