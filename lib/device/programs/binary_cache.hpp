// binary_cache.hpp - compiled programs in a folder on disk. Knows bytes and keys, no OpenCL.
//
// A file is named after the digest of its key, and begins with a digest over key and binary: half
// a file, or one of another key, is known. One that is not what was stored is removed, and told to
// the log, the first of a cache with the reason. When one is stored, those used least recently go
// until all fit into the cap, and temporary ones that a process left behind; several processes may
// do so at once. Any failure only means that a program is compiled again.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "device/log.hpp"

namespace rsh {

class BinaryCache {
public:
    static constexpr uint64_t kDefaultBytes = 256u << 20;  // of all files
    static constexpr uint64_t kMaxFileBytes = 64u << 20;   // of one, whatever the cap

    // `folder` empty: disabled, nothing is ever found or stored. `max_bytes` 0: the default.
    explicit BinaryCache(std::string folder, const Log& log = {nullptr, nullptr},
                         uint64_t max_bytes = 0)
        : folder_(std::move(folder)),
          log_(log),
          max_bytes_(max_bytes ? max_bytes : kDefaultBytes) {}

    // Folder from the descriptor, else RSH_CACHE_DIR, else XDG_CACHE_HOME/rsh, else
    // ~/.cache/rsh.
    static std::string folder_for(const char* requested);

    // Both throw only what the log does.
    std::optional<std::vector<unsigned char>> load(const std::string& key);
    void store(const std::string& key, const std::vector<unsigned char>& binary);

private:
    std::optional<std::vector<unsigned char>> read(const std::string& key) const;
    void write(const std::string& key, const std::vector<unsigned char>& binary) const;
    template <class Work>
    auto unless_it_fails(Work work) -> decltype(work());

    std::string folder_;
    Log log_;
    uint64_t max_bytes_;
    std::atomic<bool> has_told_{false};
};

}  // namespace rsh
