#include "device/programs/cache_folder.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace rsh {
namespace {

constexpr mode_t kOthersWrite = S_IWGRP | S_IWOTH;

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw Refusal(path + ": " + reason);
}

[[noreturn]] void refuse_open(const std::string& path, int error) {
    refuse(path, error == ELOOP
                     ? "is a symbolic link, must not be"
                     : "cannot be opened: " +
                           std::error_code(error, std::generic_category()).message());
}

// Of what is open, not of what has the name by now.
struct stat checked(const std::string& path, int descriptor) {
    struct stat found = {};
    if (fstat(descriptor, &found) != 0) refuse_open(path, errno);
    if (found.st_uid != geteuid())
        refuse(path, "belongs to the user " + std::to_string(found.st_uid) + ", must to " +
                         std::to_string(geteuid()));
    if (found.st_mode & kOthersWrite)
        refuse(path, "is writable by others, must be by its owner alone");
    return found;
}

int64_t nanoseconds(const timespec& time) {
    return int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

// Of `bytes` from where the file is.
bool read_all(int file, unsigned char* to, size_t bytes) {
    while (bytes > 0) {
        const ssize_t part = ::read(file, to, bytes);
        if (part < 0 && errno == EINTR) continue;
        if (part <= 0) return false;
        to += part;
        bytes -= size_t(part);
    }
    return true;
}

bool write_all(int file, const unsigned char* from, size_t bytes) {
    while (bytes > 0) {
        const ssize_t part = ::write(file, from, bytes);
        if (part < 0 && errno == EINTR) continue;
        if (part <= 0) return false;
        from += part;
        bytes -= size_t(part);
    }
    return true;
}

// With those above it, as far as that goes.
void make_folders(const std::string& path) {
    for (size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
        mkdir(path.substr(0, end).c_str(), S_IRWXU);
        if (end == std::string::npos) return;
    }
}

}  // namespace

Descriptor::~Descriptor() {
    if (is_open()) close(number_);
}

std::optional<CacheFolder> CacheFolder::open(const std::string& path) {
    Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.is_open() && errno == ENOENT) return {};
    if (!folder.is_open()) refuse_open(path, errno);
    checked(path, folder.get());
    return CacheFolder(path, std::move(folder));
}

std::optional<CacheFolder> CacheFolder::make(const std::string& path) {
    if (auto found = open(path)) return found;
    make_folders(path);
    return open(path);
}

// O_NONBLOCK: to open a FIFO for reading waits for a writer.
std::optional<std::vector<unsigned char>> CacheFolder::read(const std::string& name,
                                                            uint64_t max_bytes) const {
    const std::string path = path_ + '/' + name;
    const Descriptor file(openat(folder_.get(), name.c_str(),
                                 O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (!file.is_open() && errno == ENOENT) return {};
    if (!file.is_open()) refuse_open(path, errno);
    const struct stat found = checked(path, file.get());
    if (!S_ISREG(found.st_mode)) refuse(path, "is no regular file, must be one");
    const auto bytes = static_cast<uint64_t>(found.st_size);
    if (bytes > max_bytes)
        refuse(path, "has " + std::to_string(bytes) + " bytes, must have at most " +
                         std::to_string(max_bytes));
    std::vector<unsigned char> contents(bytes);
    if (!read_all(file.get(), contents.data(), bytes)) refuse(path, "cannot be read");
    return contents;
}

// What stands in the way under that name, be it a folder, is moved aside.
bool CacheFolder::write(const std::string& name, const std::string& temporary,
                        const std::vector<unsigned char>& contents) const {
    const int at = folder_.get();
    bool is_written = false;
    {
        const Descriptor file(openat(at, temporary.c_str(),
                                     O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                                     S_IRUSR | S_IWUSR));
        if (!file.is_open()) return false;
        is_written = write_all(file.get(), contents.data(), contents.size());
    }
    if (is_written && renameat(at, temporary.c_str(), at, name.c_str()) == 0) return true;
    const std::string aside = temporary + ".aside";
    if (is_written && renameat(at, name.c_str(), at, aside.c_str()) == 0 &&
        renameat(at, temporary.c_str(), at, name.c_str()) == 0)
        return true;
    unlinkat(at, temporary.c_str(), 0);
    return false;
}

void CacheFolder::touch(const std::string& name) const noexcept {
    utimensat(folder_.get(), name.c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
}

void CacheFolder::remove(const std::string& name) const noexcept {
    if (unlinkat(folder_.get(), name.c_str(), 0) != 0)
        unlinkat(folder_.get(), name.c_str(), AT_REMOVEDIR);
}

std::vector<CacheFolder::File> CacheFolder::files() const {
    const int again = openat(folder_.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR*)> list(again < 0 ? nullptr : fdopendir(again),
                                                   closedir);
    std::vector<File> found;
    if (!list && again >= 0) close(again);
    while (const dirent* const entry = list ? readdir(list.get()) : nullptr) {
        struct stat is = {};
        if (fstatat(folder_.get(), entry->d_name, &is, AT_SYMLINK_NOFOLLOW) != 0) continue;
        if (!S_ISREG(is.st_mode)) continue;
        found.push_back(
            {entry->d_name, nanoseconds(is.st_mtim), static_cast<uint64_t>(is.st_size)});
    }
    return found;
}

}  // namespace rsh
