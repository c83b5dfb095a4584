#include "frame_memory/device_bytes.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

namespace bench::memory {
namespace {

#ifndef RSH_COUNTS_LAYER
#define RSH_COUNTS_LAYER ""
#endif

constexpr char kVariable[] = "OPENCL_LAYERS";

// In the layers that the loader has taken; null where none of them has it.
void* find_in_layers(const char* name) {
    const char* layers = std::getenv(kVariable);
    std::istringstream paths(layers ? layers : "");
    for (std::string path; std::getline(paths, path, ':');)
        if (void* const layer = dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD))
            if (void* const found = dlsym(layer, name)) return found;
    return nullptr;
}

template <class Function>
Function of_layer(const char* name) {
    void* const found = find_in_layers(name);
    if (!found)
        throw std::runtime_error(fmt::format(
            "bytes of the device cannot be counted: {} is \"{}\", must name the layer "
            "librsh_counts_layer.so (RSH_BUILD_TESTS), and the loader must take it",
            kVariable, std::getenv(kVariable) ? std::getenv(kVariable) : ""));
    Function function = nullptr;
    std::memcpy(&function, &found, sizeof function);
    return function;
}

}  // namespace

void load_counting_layer() {
    if (std::filesystem::exists(RSH_COUNTS_LAYER)) setenv(kVariable, RSH_COUNTS_LAYER, 0);
}

DeviceBytes::DeviceBytes()
    : read_(of_layer<rsh_read_counts_function>("rsh_read_counts")),
      restart_peak_(of_layer<rsh_restart_peak_function>("rsh_restart_peak")) {}

rsh_counts DeviceBytes::read() const {
    rsh_counts counts = {};
    read_(&counts);
    return counts;
}

}  // namespace bench::memory
