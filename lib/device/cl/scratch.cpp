#include "device/cl/scratch.hpp"

#include <string>

#include "device/cl/span.hpp"
#include "device/error.hpp"

namespace rsh {
Scratch::Scratch(Recorder& recorder, const Layout& layout, cl_mem given) {
    if (layout.bytes() == 0) return;
    const Span span = span_of(given ? given : recorder.borrow_scratch(layout.bytes()));
    for (const Layout::Part& part : layout.parts()) {
        if (part.bytes == 0) continue;
        const cl_buffer_region region = {span.offset + part.offset, part.bytes};
        cl::Buffer root = span.root;
        parts_.push_back(
            {part.name,
             root.createSubBuffer(CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region)});
    }
}

cl_mem Scratch::operator[](std::string_view name) const {
    for (const Part& part : parts_)
        if (part.name == name) return part.buffer();
    return nullptr;  // a part of zero bytes
}

}  // namespace rsh
