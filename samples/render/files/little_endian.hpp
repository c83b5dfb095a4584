// little_endian.hpp - numbers in files that store the lowest byte first.
#pragma once

#include <cstdint>
#include <cstring>

namespace render {

inline uint32_t little_endian_word(const char* bytes) {
    const auto* b = reinterpret_cast<const unsigned char*>(bytes);
    return b[0] | b[1] << 8 | b[2] << 16 | static_cast<uint32_t>(b[3]) << 24;
}

inline float little_endian_float(const char* bytes) {
    const uint32_t word = little_endian_word(bytes);
    float value;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

}  // namespace render
