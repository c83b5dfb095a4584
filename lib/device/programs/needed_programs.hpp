// needed_programs.hpp - which programs calls will need, each with a kernel of it, in the order of
// their first use. Compiles nothing; programs.hpp does.
#pragma once

#include <vector>

#include "device/programs/programs.hpp"

namespace rsh {

class NeededPrograms {
public:
    void add(const KernelName& name);
    const std::vector<KernelName>& kernels() const { return kernels_; }

private:
    std::vector<KernelName> kernels_;
};

}  // namespace rsh
