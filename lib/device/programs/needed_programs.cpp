#include "device/programs/needed_programs.hpp"

#include <algorithm>
#include <cstring>

namespace rsh {

void NeededPrograms::add(const KernelName& name) {
    const auto is_of_same_program = [&name](const KernelName& known) {
        return std::strcmp(known.program, name.program) == 0 && known.options == name.options;
    };
    if (std::none_of(kernels_.begin(), kernels_.end(), is_of_same_program))
        kernels_.push_back(name);
}

}  // namespace rsh
