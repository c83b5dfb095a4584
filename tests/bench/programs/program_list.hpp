// program_list.hpp - the programs that the library asks for, from a file of lines
// "STEM OPTION OPTION...", in the order in which they are worth knowing. Compiles nothing.
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace bench {

struct ProgramName {
    std::string stem;     // "programs/tiles", of kernels/
    std::string options;  // its own: "-D RSH_WORDS=2"

    std::string text() const { return options.empty() ? stem : stem + ' ' + options; }
};

// The first of each stem before the others, and of the stems those of a frame before the rest.
std::vector<ProgramName> read_program_list(std::istream& lines);

}  // namespace bench
