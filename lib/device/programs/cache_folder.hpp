// cache_folder.hpp - a folder of small files that nobody but the user wrote. What is in a cache of
// programs is run; so its folder, and each file, must be the effective user's own and writable by
// nobody else, root's included, and a file a regular one of a sensible size: no link, no FIFO, no
// device. All work goes through the descriptor of the folder that was looked at. Knows no contents.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rsh {

// Why a folder or a file is not taken: its path, what it is and what it must be.
class Refusal : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) noexcept : number_(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
    Descriptor& operator=(Descriptor&&) = delete;

    int get() const noexcept { return number_; }
    bool is_open() const noexcept { return number_ >= 0; }

private:
    int number_;
};

class CacheFolder {
public:
    struct File {
        std::string name;
        int64_t used;  // nanoseconds since 1970
        uint64_t bytes;
    };

    // Nothing if it is not there. Throws a Refusal.
    static std::optional<CacheFolder> open(const std::string& path);
    // Makes it, and the folders above that are missing, for the user alone.
    static std::optional<CacheFolder> make(const std::string& path);

    // Nothing if it is not there. Throws a Refusal.
    std::optional<std::vector<unsigned char>> read(const std::string& name,
                                                   uint64_t max_bytes) const;
    // Writes beside it and renames, so that a reader sees all of it or what was there before.
    // Returns whether it is there.
    bool write(const std::string& name, const std::string& temporary,
               const std::vector<unsigned char>& contents) const;
    // Sets when it was last used to now.
    void touch(const std::string& name) const noexcept;
    // A folder of that name only when it is empty.
    void remove(const std::string& name) const noexcept;
    // Regular files, in no order.
    std::vector<File> files() const;

private:
    CacheFolder(std::string path, Descriptor folder)
        : path_(std::move(path)), folder_(std::move(folder)) {}

    std::string path_;
    Descriptor folder_;
};

}  // namespace rsh
