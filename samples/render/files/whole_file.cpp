// whole_file.cpp - temporary file, sync, rename.
#include "files/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <stdexcept>

namespace render {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw std::runtime_error(path + ": cannot be written: " + why);
}

std::string text_of(int error) {
    return std::strerror(error);
}

// The file that the last of a chain of links names, which need not be there.
std::string behind_links(std::string path) {
    constexpr int kMostLinks = 40;  // as Linux follows
    std::error_code none;
    for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, none)); ++i)
        path = (fs::path(path).parent_path() / fs::read_symlink(path, none)).string();
    return path;
}

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

// An open file that a path stands for: opened anew, it would be written from its start.
std::optional<int> open_file_of(const std::string& path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const char* folder : {"/dev/fd/", "/proc/self/fd/"}) {
        const std::string number = path.substr(0, std::strlen(folder)) == folder
                                       ? path.substr(std::strlen(folder))
                                       : std::string();
        if (!number.empty() && number.size() < 6 &&
            number.find_first_not_of("0123456789") == std::string::npos)
            return std::stoi(number);
    }
    return std::nullopt;
}

bool is_special(const std::string& path) {
    struct stat found {};
    return open_file_of(path) || (stat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode));
}

void require_folder(const std::string& path, const std::string& folder) {
    struct stat found {};
    if (stat(folder.c_str(), &found) != 0)
        refuse(path, "folder " + folder + ": " + text_of(errno));
    if (!S_ISDIR(found.st_mode)) refuse(path, folder + " is not a folder");
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        refuse(path, "folder " + folder + " may not be written to: " + text_of(errno));
}

// What has been renamed is there; only a power cut now could still take it back, and a folder that
// cannot be synced (not all file systems can) is no reason to say that it was not written.
void sync_folder(const std::string& folder) {
    const int open_folder = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (open_folder < 0) return;
    fsync(open_folder);
    close(open_folder);
}

}  // namespace

void require_place(const std::string& path) {
    if (path.empty())
        throw std::runtime_error("\"\": found no name of a file, one is required");
    if (open_file_of(path)) return;
    const std::string target = behind_links(path);
    struct stat found {};
    const bool is_there = stat(target.c_str(), &found) == 0;
    const int error = errno;
    if (is_there && S_ISDIR(found.st_mode)) refuse(path, "is a folder, not a file");
    if (is_there && access(target.c_str(), W_OK) != 0)
        refuse(path, "is there, but " + text_of(errno));
    if (is_there && !S_ISREG(found.st_mode)) return;
    require_folder(path, folder_of(target));
    if (!is_there && error != ENOENT) refuse(path, text_of(error));
}

WholeFile::WholeFile(const std::string& path) : path_(path), target_(behind_links(path)) {
    require_place(path);
    if (const auto open_file = open_file_of(path))
        file_ = fcntl(*open_file, F_DUPFD_CLOEXEC, 0);
    else if (is_special(target_))
        file_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    else
        open_beside();
    if (file_ < 0) fail();
}

WholeFile::~WholeFile() {
    if (file_ >= 0) ::close(file_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void WholeFile::fail() const {
    refuse(path_,
           text_of(errno) + (temporary_.empty() ? "" : "; what was there before is untouched"));
}

// The name does not grow with the file's, which may be as long as the file system allows. A file
// that a killed process left behind has another number.
void WholeFile::open_beside() {
    constexpr int kTries = 1000;
    const fs::path folder = folder_of(target_);
    for (int i = 0; i < kTries && file_ < 0; ++i) {
        const std::string name = ".rsh-" + std::to_string(getpid()) + "-" + std::to_string(i);
        const std::string candidate = (folder / (name + ".tmp")).string();
        file_ = open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file_ >= 0) temporary_ = candidate;
        if (file_ < 0 && errno != EEXIST) return;
    }
    if (file_ >= 0) keep_mode_and_owner();
}

void WholeFile::keep_mode_and_owner() const {
    struct stat before {};
    if (stat(target_.c_str(), &before) != 0) return;
    // Only root may give files away; the mode comes second, as a new owner takes bits of it.
    const bool has_owner = fchown(file_, before.st_uid, before.st_gid) == 0;
    fchmod(file_, before.st_mode & (has_owner ? 07777 : 0777));
}

template <typename Put>
void WholeFile::put_all(std::string_view bytes, const Put& put) {
    while (!bytes.empty()) {
        const ssize_t written = put(bytes);
        if (written < 0 && errno == EINTR) continue;
        if (written == 0) errno = EIO;
        if (written <= 0) fail();
        bytes.remove_prefix(static_cast<size_t>(written));
    }
}

void WholeFile::write(std::string_view bytes) {
    put_all(bytes,
            [&](std::string_view rest) { return ::write(file_, rest.data(), rest.size()); });
}

void WholeFile::write_at(size_t at, std::string_view bytes) {
    put_all(bytes, [&](std::string_view rest) {
        const size_t done = bytes.size() - rest.size();
        return pwrite(file_, rest.data(), rest.size(), static_cast<off_t>(at + done));
    });
}

void WholeFile::close() {
    const int file = file_;
    file_ = -1;
    if (::close(file) != 0 && errno != EINTR) fail();
}

void WholeFile::commit() {
    if (temporary_.empty()) return close();
    if (fsync(file_) != 0) fail();
    close();
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail();
    temporary_.clear();
    sync_folder(folder_of(target_));
}

}  // namespace render
