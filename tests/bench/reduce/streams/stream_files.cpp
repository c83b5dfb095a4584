#include "reduce/streams/stream_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "reduce/streams/bitmap.hpp"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostElements = size_t{1} << 31;  // of rsh_reduce

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw std::runtime_error(path.string() + ": " + what);
}

// All of a file, in elements of so many bytes.
std::vector<cl_uchar> read_elements(const fs::path& path, size_t element_bytes) {
    std::error_code error;
    const size_t size = fs::file_size(path, error);
    if (error) fail(path, error.message());
    if (size == 0 || size % element_bytes != 0 || size / element_bytes > kMostElements)
        fail(path, fmt::format("is {} bytes long, must be {} for each of 1 to {} elements",
                               size, element_bytes, kMostElements));
    std::vector<cl_uchar> bytes(size);
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size)))
        fail(path, "cannot be read");
    return bytes;
}

std::vector<cl_uchar> read_flags(const fs::path& path) {
    std::vector<cl_uchar> flags = read_elements(path, 1);
    const auto wrong =
        std::find_if(flags.begin(), flags.end(), [](cl_uchar f) { return f > 1; });
    if (wrong != flags.end())
        fail(path, fmt::format("byte {} is {}, must be 0 or 1", wrong - flags.begin(), *wrong));
    return flags;
}

std::vector<cl_uchar> read_pairs(const fs::path& path) {
    const std::vector<cl_uchar> bytes = read_elements(path, sizeof(StreamPair));
    std::vector<cl_uchar> flags(bytes.size() / sizeof(StreamPair));
    static_assert(RSH_NO_HIT == 0xffffffffu, "bytes of ones in any order");
    for (size_t i = 0; i < flags.size(); ++i) {
        const auto first = bytes.begin() + long(i * sizeof(StreamPair));
        flags[i] = std::any_of(first, first + 4, [](cl_uchar byte) { return byte != 0xff; });
    }
    return flags;
}

bool is_bitmap(const fs::path& path) {
    return path.extension() == ".pbm" || path.extension() == ".pgm";
}

bool has_flags(const fs::path& path) {
    return path.extension() == ".flags";
}

}  // namespace

bool has_pairs(const fs::path& path) {
    return path.extension() == ".pairs";
}

std::vector<fs::path> find_stream_files(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const fs::path& path = entry.path();
        if (has_flags(path) || has_pairs(path) || is_bitmap(path)) found.push_back(path);
    }
    if (error) fail(folder, error.message());
    if (found.empty()) fail(folder, "has no file that ends with .flags, .pairs, .pbm or .pgm");
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<cl_uchar> read_stream_file(const fs::path& path) {
    if (is_bitmap(path)) return read_bitmap(path);
    return has_pairs(path) ? read_pairs(path) : read_flags(path);
}

void write_pairs(const fs::path& path, const std::vector<StreamPair>& pairs) {
    std::vector<char> bytes;
    bytes.reserve(pairs.size() * sizeof(StreamPair));
    for (const StreamPair& pair : pairs)
        for (const cl_uint word : {pair.triangle, pair.node})
            for (int shift = 0; shift < 32; shift += 8) bytes.push_back(char(word >> shift));
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    if (!file.flush()) fail(path, "cannot be written");
}

}  // namespace bench
