// host.hpp - the machine that the device is in.
#pragma once

#include <string>

namespace bench {

// The widest vectors that the processor has and the system lets programs use: "avx512f", "avx2",
// "avx" or "sse2"; of another architecture its name. What a driver compiles for may be less: the
// device's native vector width tells.
std::string host_instruction_set();

}  // namespace bench
