// kernel_source.hpp - the text of a kernel program, its includes expanded, from the library
// itself or, while developing, from a folder.
#pragma once

#include <cstddef>
#include <string>

namespace rsh {

struct EmbeddedFile {
    const char* name;
    const unsigned char* text;
    size_t bytes;
};
extern const EmbeddedFile kEmbeddedFiles[];
extern const size_t kEmbeddedFileCount;

// Source of `<stem>.cl` with every #include "..." replaced by that file, once, and #line
// directives so that build logs name the real files. `folder` empty: the embedded files.
std::string kernel_source(const std::string& stem, const std::string& folder);

}  // namespace rsh
