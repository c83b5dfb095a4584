// compile.hpp - compiles one program as the library does, without any cache of the library's, and
// asks the driver what each of its kernels takes. Chooses no program.
#pragma once

#include "device.hpp"
#include "programs/program_list.hpp"

namespace bench {

class Compiler {
public:
    // width 0: the library's default for the device. RSH_KERNEL_DIR is honoured.
    Compiler(const Device& device, cl_uint width);

    // {"seconds", "kernels": [{"name", ...}]} with what the driver tells of each kernel, or, where
    // it does not compile, {"error": the first lines of why}.
    nlohmann::json compile(const ProgramName& name) const;

    cl_uint width() const { return width_; }

private:
    nlohmann::json build(const ProgramName& name) const;
    nlohmann::json kernels_of(const cl::Program& program) const;

    const Device& device_;
    cl_uint width_;
    bool tells_registers_;
    std::string options_;  // of every program
};

}  // namespace bench
