#include "ablation/unseen_kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "device/programs/kernel_source.hpp"

namespace bench::ablation {
namespace {

// A declaration: comments and macros do not survive preprocessing, before which some drivers look.
std::string declaration(std::string file) {
    std::replace_if(
        file.begin(), file.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    return fmt::format("typedef int unseen_{}_{};\n", file, now);
}

// The interface's types lie beside the folder of kernels.
std::string place_of(const std::string& file) {
    return (file.rfind("rsh/", 0) == 0 ? "include/" : "kernels/") + file;
}

}  // namespace

UnseenKernels::UnseenKernels() {
    std::string made = (std::filesystem::temp_directory_path() / "rsh-bench-XXXXXX").string();
    if (!mkdtemp(made.data())) throw std::runtime_error("no folder for kernels: " + made);
    folder_ = made;
    for (size_t i = 0; i < rsh::kEmbeddedFileCount; ++i) {
        const rsh::EmbeddedFile& file = rsh::kEmbeddedFiles[i];
        const std::filesystem::path path = folder_ / place_of(file.name);
        std::filesystem::create_directories(path.parent_path());
        std::ofstream out(path, std::ios::binary);
        if (path.extension() == ".cl") out << declaration(file.name);
        out.write(reinterpret_cast<const char*>(file.text), std::streamsize(file.bytes));
    }
}

UnseenKernels::~UnseenKernels() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace bench::ablation
