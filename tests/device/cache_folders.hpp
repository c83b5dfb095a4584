// cache_folders.hpp - a cache of programs in a folder of the test's own, which goes with it, and what
// is done to its files behind its back.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "device/programs/binary_cache.hpp"

namespace test {

using Binary = std::vector<unsigned char>;
inline const Binary kBinary = {1, 2, 3, 0, 255, 7};

class CacheFolders : public ::testing::Test {
protected:
    CacheFolders()
        : folder_(std::filesystem::temp_directory_path() /
                  ("rsh-binary-cache-" + std::to_string(std::random_device{}()))) {}
    ~CacheFolders() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    rsh::BinaryCache cache(uint64_t max_bytes = 0) const {
        return rsh::BinaryCache((folder_ / "made").string(), {nullptr, nullptr}, max_bytes);
    }

    // The file that storing `key` makes.
    std::filesystem::path file_of(const std::string& key) const {
        const std::string other = (folder_ / "other").string();
        rsh::BinaryCache(other).store(key, kBinary);
        const std::filesystem::path name =
            std::filesystem::directory_iterator(other)->path().filename();
        std::filesystem::remove_all(other);
        return folder_ / "made" / name;
    }

    using Keys = std::vector<std::string>;
    // More than the clock of files goes on by.
    static constexpr std::chrono::milliseconds kTick{20};

    void store_later(const char* key) const {
        std::this_thread::sleep_for(kTick);
        cache().store(key, kBinary);
    }

    // Those of `keys` whose files are there.
    Keys kept(const Keys& keys) const {
        Keys found;
        for (const std::string& key : keys)
            if (std::filesystem::exists(file_of(key))) found.push_back(key);
        return found;
    }

    std::filesystem::path folder_;
};

inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void overwrite(const std::filesystem::path& path, const std::string& data) {
    std::ofstream(path, std::ios::binary) << data;
}

inline void set_age(const std::filesystem::path& path, std::chrono::hours age) {
    std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - age);
}

}  // namespace test
