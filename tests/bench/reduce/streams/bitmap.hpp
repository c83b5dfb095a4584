// bitmap.hpp - a bitmap as keep flags, row by row.
#pragma once

#include <rsh/rsh.h>

#include <filesystem>
#include <vector>

namespace bench {

// PBM of bits (P4), of which 1 is kept, or PGM of bytes (P5), of which 0 is dropped and all others are
// kept. Throws std::runtime_error, which names file and fault.
std::vector<cl_uchar> read_bitmap(const std::filesystem::path& path);

}  // namespace bench
