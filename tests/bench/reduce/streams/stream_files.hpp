// stream_files.hpp - streams of other programs, a file each; by the end of its name:
//   .flags      a byte per element: 1 is kept, 0 is not
//   .pairs      pairs of 32-bit words, low byte first; one whose first word is RSH_NO_HIT is not kept
//   .pbm, .pgm  bitmaps, see bitmap.hpp
// All but the flags of a file is replaced, so that an answer can be checked to the last element.
#pragma once

#include <rsh/rsh.h>

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

struct StreamPair {
    cl_uint triangle, node;
};

// The files of these kinds, sorted. Throws std::runtime_error where there are none.
std::vector<std::filesystem::path> find_stream_files(const std::filesystem::path& folder);

// Throws std::runtime_error, which names file and fault: a size, a byte.
std::vector<cl_uchar> read_stream_file(const std::filesystem::path& path);

bool has_pairs(const std::filesystem::path& path);  // by its name

void write_pairs(const std::filesystem::path& path, const std::vector<StreamPair>& pairs);

}  // namespace bench
