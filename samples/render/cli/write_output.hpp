// write_output.hpp - a file that rsh-render leaves: written whole, or not at all when a signal asks to
// end.
#pragma once

#include <string>
#include <string_view>

#include "files/whole_file.hpp"

namespace render {

// Throws Interrupted instead of replacing what is at `path`. A signal that comes later finds the new
// file there, so that the exit status of a program that ends by it says which of them is.
void write_output(const std::string& path, std::string_view bytes);
// The same for a file that has its bytes.
void commit_output(WholeFile& file);

}  // namespace render
