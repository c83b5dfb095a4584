// temporary_folder.hpp - a folder of its own for the files that one test writes; removed with
// it. Also archives, and what tests say about files that must not load.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace render {

class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    // Writes a file, with the folders above it, and returns its path.
    std::string write(const std::string& name, const std::string& bytes) const;
    std::string write_xz(const std::string& name, const std::string& bytes) const;
    std::string write_tar_xz(const std::string& name,
                             const std::map<std::string, std::string>& members) const;

private:
    std::filesystem::path folder_;
};

// The message of the LoadError that load_mesh(path) throws; fails the test if it throws none.
std::string error_of_mesh(const std::string& path);

// Little-endian bytes of floats and 32-bit integers, one after the other.
template <typename T>
std::string bytes_of(std::initializer_list<T> values) {
    static_assert(sizeof(T) == 4);
    return std::string(reinterpret_cast<const char*>(values.begin()), 4 * values.size());
}

}  // namespace render
