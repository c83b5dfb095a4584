// whole_file.hpp - writes files whole or not at all: whatever happens in between, at the path is what
// was there before or all of the new. Knows no format.
#pragma once

#include <string>
#include <string_view>

namespace render {

// Throws std::runtime_error, which begins with `path`, unless a WholeFile can be begun there: its
// folder is there and can be written to, and it is neither a folder nor a file that may not be
// changed. Writes nothing.
void require_place(const std::string& path);

// Bytes go to a file beside the path, which takes its place by commit(); without that it is removed.
// A link stays, and what it points to is replaced; mode and owner of what was there are kept. What
// is no regular file (a pipe, a terminal, /dev/stdout) is written to as it is, with no way back.
class WholeFile {
public:
    explicit WholeFile(const std::string& path);  // all functions throw std::runtime_error
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    void write(std::string_view bytes);
    // `at` bytes from the file's start, which need not be written yet; not for a stream.
    void write_at(size_t at, std::string_view bytes);
    bool is_stream() const { return temporary_.empty(); }  // no regular file
    void commit();                                         // to the disk, then into its place

private:
    [[noreturn]] void fail() const;  // with errno
    template <typename Put>
    void put_all(std::string_view bytes, const Put& put);
    void open_beside();
    void keep_mode_and_owner() const;
    void close();

    std::string path_;       // as the user named it
    std::string target_;     // behind links
    std::string temporary_;  // empty: written as it is
    int file_ = -1;
};

}  // namespace render
