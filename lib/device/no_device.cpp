// no_device.cpp - a message with a hint.
#include "device/no_device.hpp"

#include <cstdlib>

namespace rsh {
namespace {

// The first of these that is set, as PoCL goes through them.
std::string pocl_cache() {
    for (const char* name : {"POCL_CACHE_DIR", "XDG_CACHE_HOME", "HOME"})
        if (const char* value = std::getenv(name))
            return std::string(name) + " is \"" + value + "\"";
    return "HOME is not set";
}

}  // namespace

std::string no_device_text(const std::string& platforms) {
    std::string text = "no OpenCL device: there are no devices on " + platforms;
    if (platforms.find("Portable Computing Language") != std::string::npos)
        text += "; PoCL has none when it cannot write to its cache: " + pocl_cache() +
                ", which must be a folder that can be written to";
    return text;
}

}  // namespace rsh
