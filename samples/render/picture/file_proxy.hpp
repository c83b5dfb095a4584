// file_proxy.hpp - a WholeFile as OpenImageIO writes to one. Knows no format.
#pragma once

#include <OpenImageIO/filesystem.h>

#include <exception>
#include <string>

#include "files/whole_file.hpp"

namespace render {

// Bytes go into the file at once; into memory where the file is a stream, as formats go back to what
// they wrote before.
class FileProxy final : public OIIO::Filesystem::IOProxy {
public:
    explicit FileProxy(WholeFile& file);

    // Not "file", which OpenImageIO takes for its own class.
    const char* proxytype() const override { return "whole file"; }
    size_t write(const void* bytes, size_t count) override;
    size_t pwrite(const void* bytes, size_t count, int64_t offset) override;
    size_t size() const override { return size_; }

    // Throws what a write met: formats written in C would not let it through.
    void require_written() const;
    void finish();  // gives a stream its bytes

private:
    void put(const char* bytes, size_t count, size_t offset);

    WholeFile& file_;
    size_t size_ = 0;
    std::string memory_;  // of a stream
    std::exception_ptr error_;
};

}  // namespace render
