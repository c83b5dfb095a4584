// unseen_kernels.hpp - the library's kernels in a folder, for a moment, with names in them that no compiler
// has seen: drivers keep what they compiled, too.
#pragma once

#include <filesystem>
#include <string>

namespace bench::ablation {

class UnseenKernels {
public:
    UnseenKernels();
    ~UnseenKernels();
    UnseenKernels(const UnseenKernels&) = delete;
    UnseenKernels& operator=(const UnseenKernels&) = delete;

    std::string folder() const { return (folder_ / "kernels").string(); }

private:
    std::filesystem::path folder_;
};

}  // namespace bench::ablation
