// resident_memory.cpp - Linux says it in pages.
#include "device/resident_memory.hpp"

#include <unistd.h>

#include <fstream>

namespace render {

size_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    size_t whole = 0, resident = 0;
    if (!(file >> whole >> resident)) return 0;
    return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace render
