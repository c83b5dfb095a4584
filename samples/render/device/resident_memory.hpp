// resident_memory.hpp - how much memory this process has.
#pragma once

#include <cstddef>

namespace render {

// Bytes of the process that are in memory; 0 where the system has no /proc.
size_t resident_bytes();

}  // namespace render
