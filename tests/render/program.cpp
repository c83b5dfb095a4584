// program.cpp - through a shell; images by OpenImageIO.
#include "program.hpp"

#include <OpenImageIO/imageio.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace render {

Ended run(const std::string& arguments, const std::string& environment) {
    const std::string command = environment + " '" RSH_RENDER "' " + arguments + " 2>&1";
    Ended ended;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> block;
    while (const size_t got = fread(block.data(), 1, block.size(), pipe))
        ended.printed.append(block.data(), got);
    const int status = pclose(pipe);
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ended;
}

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string description_of(const std::string& path) {
    const auto image = OIIO::ImageInput::open(path);
    if (!image) return OIIO::geterror();
    return image->spec().get_string_attribute("ImageDescription").str();
}

}  // namespace render
