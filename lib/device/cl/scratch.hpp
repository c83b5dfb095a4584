// scratch.hpp - the parts of one call's scratch memory as buffers of their own: the caller's
// buffer, or a block of the context's pool, cut up by a Layout.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"

namespace rsh {

class Scratch {
public:
    // `given` NULL: from the pool, until the recorder's commands ended.
    Scratch(Recorder& recorder, const Layout& layout, cl_mem given);

    cl_mem operator[](std::string_view name) const;

private:
    struct Part {
        std::string name;
        cl::Buffer buffer;
    };
    std::vector<Part> parts_;
};

}  // namespace rsh
