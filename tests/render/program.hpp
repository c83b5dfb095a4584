// program.hpp - rsh-render as a program: what it prints, how it ends, and the files that it leaves.
#pragma once

#include <string>

namespace render {

struct Ended {
    int status = -1;      // as a shell sees it
    std::string printed;  // on both streams
};

// `environment`: what a shell may have before the program's name.
Ended run(const std::string& arguments, const std::string& environment = "");

// The bytes of a file; "": there is none.
std::string content(const std::string& path);

// What an image says of itself; "": nothing.
std::string description_of(const std::string& path);

}  // namespace render
