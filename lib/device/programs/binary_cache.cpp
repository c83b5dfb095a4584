#include "device/programs/binary_cache.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

namespace fs = std::filesystem;

namespace rsh {
namespace {

constexpr char kMagic[8] = {'r', 's', 'h', '-', 'b', 'i', 'n', '1'};
constexpr const char* kSuffix = ".rshbin";
constexpr const char* kTemporarySuffix = ".tmp";
constexpr std::chrono::hours kOrphanAge{1};  // no write takes that long

// FNV-1a; two of them with different seeds name a file, one guards its contents.
uint64_t hash(const void* data, size_t bytes, uint64_t seed) {
    uint64_t value = 0xcbf29ce484222325u ^ seed;
    for (size_t i = 0; i < bytes; ++i)
        value = (value ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
    return value;
}

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

// Unique among processes and threads that store the same program at the same time.
std::string temporary_suffix() {
    static std::atomic<unsigned> counter{0};
    return "." + std::to_string(std::random_device{}()) + "." + std::to_string(counter++) +
           kTemporarySuffix;
}

// Other files in the folder are not ours to touch.
bool is_orphan(const fs::directory_entry& entry) {
    const fs::path& path = entry.path();
    if (path.extension() != kTemporarySuffix) return false;
    if (path.filename().string().find(std::string(kSuffix) + ".") == std::string::npos)
        return false;
    std::error_code failed;
    const fs::file_time_type written = entry.last_write_time(failed);
    return !failed && written < fs::file_time_type::clock::now() - kOrphanAge;
}

// What `work` returns, or as good as nothing: reading a folder throws in iostreams, entropy may
// be missing, memory too.
template <class Work>
auto unless_it_fails(Work work) noexcept -> decltype(work()) {
    try {
        return work();
    } catch (const std::exception&) {
        return {};
    }
}

std::string file_header(const std::string& key, const std::vector<unsigned char>& binary) {
    const uint64_t words[3] = {key.size(), binary.size(),
                               hash(binary.data(), binary.size(), 0)};
    std::string header(kMagic, sizeof kMagic);
    header.append(reinterpret_cast<const char*>(words), sizeof words);
    return header + key;
}

}  // namespace

std::string BinaryCache::folder_for(const char* requested) {
    if (requested) return requested;
    if (std::getenv("RSH_CACHE_DIR")) return environment("RSH_CACHE_DIR");
    if (!environment("XDG_CACHE_HOME").empty()) return environment("XDG_CACHE_HOME") + "/rsh";
    if (!environment("HOME").empty()) return environment("HOME") + "/.cache/rsh";
    return "";
}

std::string BinaryCache::path_of(const std::string& key) const {
    char name[33];
    std::snprintf(name, sizeof name, "%016llx%016llx",
                  static_cast<unsigned long long>(hash(key.data(), key.size(), 1)),
                  static_cast<unsigned long long>(hash(key.data(), key.size(), 2)));
    return folder_ + "/" + name + kSuffix;
}

std::optional<std::vector<unsigned char>> BinaryCache::load(
    const std::string& key) const noexcept {
    return unless_it_fails([&] { return read(key); });
}

void BinaryCache::store(const std::string& key,
                        const std::vector<unsigned char>& binary) const noexcept {
    unless_it_fails([&] {
        if (folder_.empty() || binary.empty()) return false;
        write(key, binary);
        evict();
        return true;
    });
}

std::optional<std::vector<unsigned char>> BinaryCache::read(const std::string& key) const {
    if (folder_.empty()) return {};
    const std::string path = path_of(key);
    std::ifstream file(path, std::ios::binary);
    if (!file) return {};
    const std::vector<unsigned char> all{std::istreambuf_iterator<char>(file), {}};
    const size_t prefix = sizeof kMagic + 3 * sizeof(uint64_t) + key.size();
    if (all.size() <= prefix) return {};
    std::vector<unsigned char> binary(all.begin() + prefix, all.end());
    const std::string expected = file_header(key, binary);
    if (std::memcmp(all.data(), expected.data(), prefix) != 0) return {};
    std::error_code ignored;
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
    return binary;
}

void BinaryCache::write(const std::string& key,
                        const std::vector<unsigned char>& binary) const {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    const std::string path = path_of(key), temporary = path + temporary_suffix();
    {
        std::ofstream file(temporary, std::ios::binary);
        const std::string header = file_header(key, binary);
        file.write(header.data(), static_cast<std::streamsize>(header.size()));
        file.write(reinterpret_cast<const char*>(binary.data()),
                   static_cast<std::streamsize>(binary.size()));
        if (!file.flush()) failed = std::make_error_code(std::errc::io_error);
    }
    if (!failed) fs::rename(temporary, path, failed);
    if (failed) fs::remove(temporary, failed);
}

void BinaryCache::evict() const {
    struct File {
        fs::file_time_type used;
        uint64_t bytes;
        fs::path path;
    };
    std::vector<File> files;
    uint64_t total = 0;
    std::error_code failed;
    for (fs::directory_iterator at(folder_), end; at != end; at.increment(failed)) {
        if (is_orphan(*at)) fs::remove(at->path(), failed);
        if (at->path().extension() != kSuffix) continue;
        const File file = {at->last_write_time(failed), failed ? 0 : at->file_size(failed),
                           at->path()};
        if (failed) continue;  // another process evicts as well
        files.push_back(file);
        total += file.bytes;
    }
    std::sort(files.begin(), files.end(),
              [](const File& a, const File& b) { return a.used < b.used; });
    for (size_t i = 0; i < files.size() && total > max_bytes_; ++i) {
        fs::remove(files[i].path, failed);
        total -= files[i].bytes;
    }
}

}  // namespace rsh
