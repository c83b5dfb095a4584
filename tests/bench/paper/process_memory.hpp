// process_memory.hpp - the memory of this program.
#pragma once

#include <cstddef>

namespace bench::paper {

// The most that was resident at once; 0 where the system does not tell.
size_t process_peak_bytes();

}  // namespace bench::paper
