#include "device/cl/scratch.hpp"

#include "device/cl/span.hpp"

namespace rsh {

Scratch::Scratch(Recorder& recorder, const Layout& layout, cl_mem given)
    : layout_(layout), buffers_(layout.parts().size()) {
    if (layout.bytes() == 0) return;
    if (recorder.only_notes()) {
        take_stand_ins(recorder.wrong_buffers());
        return;
    }
    if (given && info<size_t>(given, CL_MEM_SIZE) < layout.bytes())
        throw Error(RSH_INTERNAL_ERROR, "scratch: holds ", info<size_t>(given, CL_MEM_SIZE),
                    " bytes, must hold ", layout.bytes());
    const Span span = span_of(given ? given : recorder.borrow_scratch(layout.bytes()));
    for (size_t i = 0; i < buffers_.size(); ++i) {
        const Layout::Part& part = layout.parts()[i];
        if (part.bytes == 0) continue;
        buffers_[i] = part_of(span, part.offset, part.bytes);
    }
}

// A buffer in the place of each part, for calls that look at nothing but whether it is there.
void Scratch::take_stand_ins(cl_mem buffer) {
    for (size_t i = 0; i < buffers_.size(); ++i)
        if (layout_.parts()[i].bytes > 0) buffers_[i] = Buffer::retained(buffer);
}

cl_mem Scratch::operator[](std::string_view name) const {
    return buffers_[layout_.number_of(name)].get();
}

cl_mem Scratch::find(std::string_view name) const {
    return layout_.has(name) ? (*this)[name] : nullptr;
}

}  // namespace rsh
