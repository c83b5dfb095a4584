// container.cpp - header and chunks of .glb files (glTF 2.0, 4).
#include "import/gltf/file/container.hpp"

#include <fmt/format.h>

#include "files/little_endian.hpp"
#include "files/text_scan.hpp"

namespace render {
namespace {

constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr uint32_t kJson = 0x4e4f534a, kBinary = 0x004e4942;

void require(bool holds, const std::string& location, const std::string& message) {
    if (!holds) throw LoadError(location + ": " + message);
}

uint32_t word(const std::string& bytes, size_t at) {
    return little_endian_word(bytes.data() + at);
}

struct Chunk {
    size_t first = 0, length = 0;
    size_t end() const { return first + length; }
};

Chunk chunk_at(const std::string& bytes, size_t at, const char* name, uint32_t type,
               const std::string& location) {
    require(bytes.size() - at >= kChunkHeaderBytes, location,
            fmt::format("has {} bytes for the header of chunk {}, must have {}",
                        bytes.size() - at, name, kChunkHeaderBytes));
    const Chunk chunk{at + kChunkHeaderBytes, word(bytes, at)};
    require(word(bytes, at + 4) == type, location,
            fmt::format("the type of chunk {} is {:#010x}, must be {:#010x}", name,
                        word(bytes, at + 4), type));
    require(chunk.length <= bytes.size() - chunk.first, location,
            fmt::format("chunk {} promises {} bytes, the file holds {} from there on", name,
                        chunk.length, bytes.size() - chunk.first));
    require(chunk.length > 0 && chunk.length % 4 == 0, location,
            fmt::format("chunk {} has {} bytes, must have a multiple of 4 and at least 4", name,
                        chunk.length));
    return chunk;
}

}  // namespace

GltfContainer open_container(const std::string& bytes, const std::string& location) {
    require(bytes.size() <= UINT32_MAX, location,
            fmt::format("has {} bytes, must have at most {}", bytes.size(), UINT32_MAX));
    if (bytes.compare(0, 4, "glTF") != 0) return {bytes, false, 0};
    require(bytes.size() >= kHeaderBytes, location,
            fmt::format("has {} bytes, a .glb header needs {}", bytes.size(), kHeaderBytes));
    require(word(bytes, 4) == 2, location,
            fmt::format("the version of its .glb header is {}, must be 2", word(bytes, 4)));
    require(word(bytes, 8) == bytes.size(), location,
            fmt::format("its .glb header promises {} bytes, the file has {}", word(bytes, 8),
                        bytes.size()));
    const Chunk json = chunk_at(bytes, kHeaderBytes, "JSON", kJson, location);
    GltfContainer result{bytes.substr(json.first, json.length), true, 0};
    if (json.end() < bytes.size())
        result.binary_bytes = chunk_at(bytes, json.end(), "BIN", kBinary, location).length;
    return result;
}

}  // namespace render
