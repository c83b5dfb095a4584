// png_bytes.hpp - PNG files to the byte, for tests of what their chunks mean.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>

namespace render {

inline std::string big_endian(uint32_t word) {
    return {static_cast<char>(word >> 24), static_cast<char>(word >> 16),
            static_cast<char>(word >> 8), static_cast<char>(word)};
}

inline std::string png_chunk(const std::string& kind, const std::string& data) {
    const std::string body = kind + data;
    const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), body.size());
    return big_endian(data.size()) + body + big_endian(static_cast<uint32_t>(sum));
}

struct PngHead {
    uint32_t width = 2, height = 2;
    int bits = 8;
    int kind = 2;  // 0: grey, 2: r g b, 3: palette, 4: grey and alpha, 6: r g b a
};

// All pixels are `pixel`; `chunks` stand between the head and the pixels.
inline std::string png_file(const PngHead& head, const std::string& pixel,
                            const std::string& chunks = "") {
    std::string rows;
    for (uint32_t y = 0; y < head.height; ++y) {
        rows += '\0';
        for (uint32_t x = 0; x < head.width; ++x) rows += pixel;
    }
    uLongf size = compressBound(rows.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(rows.data()), rows.size());
    packed.resize(size);
    const std::string kinds{static_cast<char>(head.bits), static_cast<char>(head.kind), 0, 0,
                            0};
    return "\x89PNG\r\n\x1a\n" +
           png_chunk("IHDR", big_endian(head.width) + big_endian(head.height) + kinds) +
           chunks + png_chunk("IDAT", packed) + png_chunk("IEND", "");
}

}  // namespace render
