#include "api/buffers.hpp"

#include "api/check.hpp"

namespace rsh {
namespace {

// Saturates: no offset wraps round to a small size.
cl_ulong end_of(cl_ulong offset, cl_ulong bytes) {
    return offset > ~cl_ulong{0} - bytes ? ~cl_ulong{0} : offset + bytes;
}

void check_size(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes) {
    if (info<cl_context>(buffer, CL_MEM_CONTEXT) != context.cl.get())
        throw Error(RSH_INVALID_VALUE, field,
                    ": is of another cl_context, must be of the rsh_context's");
    const cl_ulong actual = info<size_t>(buffer, CL_MEM_SIZE);
    if (actual < bytes)
        throw Error(RSH_BUFFER_TOO_SMALL, field, ": holds ", actual, " bytes, needs ", bytes);
}

}  // namespace

void Buffers::in(const char* field, cl_mem buffer, cl_ulong bytes, cl_ulong offset) {
    if (bytes == 0 && !buffer) return;
    require_not_null(buffer, field);
    add(field, buffer, offset, bytes, false);
}

void Buffers::out(const char* field, cl_mem buffer, cl_ulong bytes) {
    if (bytes == 0 && !buffer) return;
    require_not_null(buffer, field);
    add(field, buffer, 0, bytes, true);
}

void Buffers::optional_in(const char* field, cl_mem buffer, cl_ulong bytes, cl_ulong offset) {
    if (buffer) in(field, buffer, bytes, offset);
}

void Buffers::optional_out(const char* field, cl_mem buffer, cl_ulong bytes) {
    if (buffer) out(field, buffer, bytes);
}

void Buffers::scratch(cl_mem buffer, size_t bytes) {
    if (buffer) out("scratch", buffer, bytes);
    if (bytes > context_.caps.max_allocation)
        throw Error(RSH_UNSUPPORTED, "scratch: needs ", bytes,
                    " bytes, the device allocates at most ", context_.caps.max_allocation);
}

void Buffers::add(const char* field, cl_mem buffer, cl_ulong offset, cl_ulong bytes,
                  bool is_written) {
    check_size(context_, field, buffer, end_of(offset, bytes));
    if (bytes == 0) return;
    const Span span = span_of(buffer);
    const cl_ulong begin = span.offset + offset, end = begin + bytes;
    for (const Use& other : uses_)
        if ((is_written || other.is_written) && other.root == span.root && begin < other.end &&
            other.begin < end)
            throw Error(RSH_INVALID_VALUE, field, ": is bytes ", begin, " .. ", end,
                        " of a buffer, must not overlap ", other.field, ", bytes ", other.begin,
                        " .. ", other.end);
    uses_.push_back({field, span.root, begin, end, is_written});
}

}  // namespace rsh
