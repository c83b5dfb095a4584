// scratch.hpp - the parts of one call's scratch memory as buffers of their own: the caller's
// buffer, or a block of the context's pool, cut up by a Layout.
#pragma once

#include <string_view>
#include <vector>

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"

namespace rsh {

class Scratch {
public:
    // `given` NULL: from the pool, until the recorder's commands ended.
    Scratch(Recorder& recorder, const Layout& layout, cl_mem given);

    // NULL for a part of no bytes. Throws where the layout has none of that name.
    cl_mem operator[](std::string_view name) const;
    // NULL there as well: for parts that only some calls have.
    cl_mem find(std::string_view name) const;

private:
    void take_stand_ins(cl_mem buffer);

    Layout layout_;
    std::vector<Buffer> buffers_;  // of its parts
};

}  // namespace rsh
