#include "device/programs/binary_cache.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>

#include "device/programs/cache_folder.hpp"
#include "device/programs/sha256.hpp"

namespace rsh {
namespace {

constexpr char kMagic[8] = {'r', 's', 'h', '-', 'b', 'i', 'n', '2'};
constexpr size_t kHeaderBytes = sizeof kMagic + sizeof(Sha256::Digest);
constexpr const char* kSuffix = ".rshbin";
constexpr const char* kTemporarySuffix = ".tmp";
constexpr std::chrono::hours kOrphanAge{1};  // no write takes that long

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

constexpr size_t kDigits = 2 * sizeof(Sha256::Digest);

// `name` is a digest and what follows it. Other files in the folder are not ours to touch.
bool is_ours(const std::string& name) {
    return name.size() > kDigits && name.find_first_not_of("0123456789abcdef") == kDigits &&
           name.compare(kDigits, std::strlen(kSuffix), kSuffix) == 0;
}

bool is_program(const CacheFolder::File& file) {
    return is_ours(file.name) && file.name.size() == kDigits + std::strlen(kSuffix);
}

std::string name_of(const std::string& key) {
    Sha256 sum;
    sum.add(key.data(), key.size());
    return hexadecimal(sum.digest()) + kSuffix;
}

// Unique among threads and processes, also of machines that share the folder, which store the same program at
// the same time. std::random_device of a static libstdc++ would ask for the newest glibc.
std::string temporary_of(const std::string& name) {
    static std::atomic<unsigned> counter{0};
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    return name + "." + std::to_string(getpid()) + "." + std::to_string(now) + "." +
           std::to_string(counter++) + kTemporarySuffix;
}

// The length of the key comes first, lest a binary begin with what another key ends with.
Sha256::Digest digest_of(const std::string& key, const unsigned char* binary, size_t bytes) {
    const uint64_t key_bytes = key.size();
    Sha256 sum;
    sum.add(&key_bytes, sizeof key_bytes);
    sum.add(key.data(), key.size());
    sum.add(binary, bytes);
    return sum.digest();
}

bool is_orphan(const CacheFolder::File& file) {
    if (!is_ours(file.name) || !ends_with(file.name, kTemporarySuffix)) return false;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::nanoseconds(file.used) < now - kOrphanAge;
}

// What another process removes meanwhile counts as removed here: both choose the same files.
void evict(const CacheFolder& folder, uint64_t max_bytes) {
    std::vector<CacheFolder::File> programs;
    uint64_t total = 0;
    for (CacheFolder::File& file : folder.files()) {
        if (is_orphan(file)) folder.remove(file.name);
        if (!is_program(file)) continue;
        total += file.bytes;
        programs.push_back(std::move(file));
    }
    std::sort(programs.begin(), programs.end(),
              [](const auto& a, const auto& b) { return a.used < b.used; });
    for (const CacheFolder::File& file : programs) {
        if (total <= max_bytes) return;
        folder.remove(file.name);
        total -= file.bytes;
    }
}

}  // namespace

// A relative XDG_CACHE_HOME is to be ignored, its specification says.
std::string BinaryCache::folder_for(const char* requested) {
    if (requested) return requested;
    if (std::getenv("RSH_CACHE_DIR")) return environment("RSH_CACHE_DIR");
    const std::string cache = environment("XDG_CACHE_HOME"), home = environment("HOME");
    if (!cache.empty() && cache[0] == '/') return cache + "/rsh";
    if (!home.empty()) return home + "/.cache/rsh";
    return "";
}

// What `work` returns, or as good as nothing: entropy may be missing, memory too. A refusal is
// told when it is the first.
template <class Work>
auto BinaryCache::unless_it_fails(Work work) -> decltype(work()) {
    char reason[1024];
    Text text(reason, sizeof reason);
    try {
        return work();
    } catch (const Refusal& refusal) {
        text.add("program cache: ", refusal.what(), "; programs are compiled anew");
    } catch (const std::exception&) {
        return {};
    }
    if (!has_told_.exchange(true)) log_(reason);
    return {};
}

std::optional<std::vector<unsigned char>> BinaryCache::load(const std::string& key) {
    if (folder_.empty()) return {};
    return unless_it_fails([&] { return read(key); });
}

void BinaryCache::store(const std::string& key, const std::vector<unsigned char>& binary) {
    if (folder_.empty() || binary.empty()) return;
    unless_it_fails([&] {
        write(key, binary);
        return true;
    });
}

std::optional<std::vector<unsigned char>> BinaryCache::read(const std::string& key) const {
    const auto folder = CacheFolder::open(folder_);
    if (!folder) return {};
    const std::string name = name_of(key);
    try {
        auto all = folder->read(name, kMaxFileBytes);
        if (!all) return {};
        const size_t bytes = all->size() - std::min(all->size(), kHeaderBytes);
        const Sha256::Digest digest = digest_of(key, all->data() + all->size() - bytes, bytes);
        if (bytes == 0 || std::memcmp(all->data(), kMagic, sizeof kMagic) != 0 ||
            std::memcmp(all->data() + sizeof kMagic, digest.data(), digest.size()) != 0)
            throw Refusal(folder_ + '/' + name +
                          ": is not what was stored, must have the digest that it begins with");
        folder->touch(name);
        all->erase(all->begin(), all->begin() + kHeaderBytes);
        return all;
    } catch (const Refusal&) {
        folder->remove(name);
        throw;
    }
}

void BinaryCache::write(const std::string& key,
                        const std::vector<unsigned char>& binary) const {
    if (binary.size() + kHeaderBytes > std::min(max_bytes_, kMaxFileBytes)) return;
    const auto folder = CacheFolder::make(folder_);
    if (!folder) return;
    const Sha256::Digest digest = digest_of(key, binary.data(), binary.size());
    std::vector<unsigned char> contents(kHeaderBytes + binary.size());
    std::memcpy(contents.data(), kMagic, sizeof kMagic);
    std::memcpy(contents.data() + sizeof kMagic, digest.data(), digest.size());
    std::memcpy(contents.data() + kHeaderBytes, binary.data(), binary.size());
    const std::string name = name_of(key);
    folder->write(name, temporary_of(name), contents);
    evict(*folder, max_bytes_);
}

}  // namespace rsh
