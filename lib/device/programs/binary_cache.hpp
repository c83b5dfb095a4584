// binary_cache.hpp - compiled programs in a folder on disk. Knows bytes and keys, no OpenCL.
//
// A file holds a key, a checksum and the binary; it is written under a temporary name and
// renamed, so a reader sees all of it or nothing. Files used least recently go when the folder
// grows past its cap, and temporary ones that a process left behind. Nothing here throws: any
// failure only means that a program is compiled again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rsh {

class BinaryCache {
public:
    static constexpr uint64_t kMaxBytes = 64u << 20;

    // `folder` empty: disabled, nothing is ever found or stored.
    explicit BinaryCache(std::string folder, uint64_t max_bytes = kMaxBytes)
        : folder_(std::move(folder)), max_bytes_(max_bytes) {}

    // Folder from the descriptor, else RSH_CACHE_DIR, else XDG_CACHE_HOME/rsh, else
    // ~/.cache/rsh.
    static std::string folder_for(const char* requested);

    std::optional<std::vector<unsigned char>> load(const std::string& key) const noexcept;
    void store(const std::string& key, const std::vector<unsigned char>& binary) const noexcept;

private:
    std::optional<std::vector<unsigned char>> read(const std::string& key) const;
    void write(const std::string& key, const std::vector<unsigned char>& binary) const;
    std::string path_of(const std::string& key) const;
    void evict() const;

    std::string folder_;
    uint64_t max_bytes_;
};

}  // namespace rsh
