// changed_kernels.hpp - the kernels of the tree in a folder of their own, one of them changed, and
// a context that compiles from there: plays drivers that miscompile, and counts that are large.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/device.hpp"
#include "support/source_tree.hpp"

namespace test {

class ChangedKernels {
public:
    ChangedKernels(const std::string& file, const std::string& from, const std::string& to,
                   rsh_log log = nullptr, void* log_user = nullptr) {
        std::filesystem::create_directories(root_ / "include/rsh");
        std::filesystem::copy(source_tree() / "kernels", root_ / "kernels",
                              std::filesystem::copy_options::recursive);
        std::filesystem::copy(source_tree() / "include/rsh/rsh_types.h", root_ / "include/rsh");
        change(root_ / "kernels" / file, from, to);
        const std::string folder = (root_ / "kernels").string();
        rsh_context_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.context = device().context();
        desc.device = device().device();
        desc.cache_dir = "";
        desc.kernel_dir = folder.c_str();
        desc.log = log;
        desc.log_user = log_user;
        RSH_CHECK(rsh_create_context(&desc, &context_));
    }
    ~ChangedKernels() {
        rsh_release_context(context_);
        std::error_code ignored;
        std::filesystem::remove_all(root_, ignored);
    }
    ChangedKernels(const ChangedKernels&) = delete;
    ChangedKernels& operator=(const ChangedKernels&) = delete;

    rsh_context context() const { return context_; }

private:
    static void change(const std::filesystem::path& path, const std::string& from,
                       const std::string& to) {
        std::stringstream text;
        text << std::ifstream(path).rdbuf();
        std::string source = text.str();
        const size_t at = source.find(from);
        ASSERT_NE(at, std::string::npos) << path << " has no \"" << from << '"';
        std::ofstream(path) << source.replace(at, from.size(), to);
    }

    std::filesystem::path root_ =
        std::filesystem::temp_directory_path() /
        ("rsh-kernels-" + std::to_string(getpid()) + "-" +
         ::testing::UnitTest::GetInstance()->current_test_info()->name());
    rsh_context context_ = nullptr;
};

}  // namespace test
