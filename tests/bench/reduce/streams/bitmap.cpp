#include "reduce/streams/bitmap.hpp"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <stdexcept>

namespace bench {
namespace {

constexpr size_t kMostPixels = size_t{1} << 31;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
    throw std::runtime_error(path.string() + ": " + what);
}

// The next word of the head, behind space and comments.
std::string next_word(std::istream& file) {
    std::string word;
    while (file >> word && word[0] == '#')
        file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    return word;
}

size_t next_number(std::istream& file, const std::filesystem::path& path, const char* name,
                   size_t most) {
    const std::string word = next_word(file);
    const bool is_number = !word.empty() && word.size() < 12 &&
                           word.find_first_not_of("0123456789") == std::string::npos;
    const size_t number = is_number ? std::stoull(word) : 0;
    if (number < 1 || number > most)
        fail(path, fmt::format("{} is \"{}\", must be 1 to {}", name, word, most));
    return number;
}

std::vector<cl_uchar> read_bytes(std::istream& file, const std::filesystem::path& path,
                                 size_t count) {
    std::vector<cl_uchar> bytes(count);
    file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(count));
    if (size_t(file.gcount()) != count)
        fail(path,
             fmt::format("has {} bytes behind its head, must have {}", file.gcount(), count));
    return bytes;
}

// Rows of bits, the highest first, padded to bytes.
std::vector<cl_uchar> read_bits(std::istream& file, const std::filesystem::path& path,
                                size_t width, size_t height) {
    const size_t row_bytes = (width + 7) / 8;
    const std::vector<cl_uchar> rows = read_bytes(file, path, row_bytes * height);
    std::vector<cl_uchar> flags;
    flags.reserve(width * height);
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x)
            flags.push_back(rows[y * row_bytes + x / 8] >> (7 - x % 8) & 1);
    return flags;
}

}  // namespace

std::vector<cl_uchar> read_bitmap(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "cannot be read");
    const std::string magic = next_word(file);
    if (magic != "P4" && magic != "P5")
        fail(path,
             fmt::format("begins with \"{}\", must be a bitmap: P4 or P5", magic.substr(0, 8)));
    const size_t width = next_number(file, path, "width", kMostPixels);
    const size_t height = next_number(file, path, "height", kMostPixels / width);
    if (magic == "P5") next_number(file, path, "highest value", 255);
    file.get();  // one space ends the head
    if (magic == "P4") return read_bits(file, path, width, height);
    std::vector<cl_uchar> flags = read_bytes(file, path, width * height);
    for (cl_uchar& flag : flags) flag = flag != 0;
    return flags;
}

}  // namespace bench
