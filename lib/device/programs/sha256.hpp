// sha256.hpp - the digest of FIPS 180-4, by which a file is known to be what was written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace rsh {

class Sha256 {
public:
    using Digest = std::array<unsigned char, 32>;

    void add(const void* data, size_t bytes) noexcept;
    // Of all that was added; nothing can be added afterwards.
    Digest digest() noexcept;

private:
    void add_block(const unsigned char* block) noexcept;

    std::array<uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<unsigned char, 64> block_ = {};
    uint64_t bytes_ = 0;  // block_ holds the last bytes_ % 64
};

// Two lower-case digits a byte.
std::string hexadecimal(const Sha256::Digest& digest);

}  // namespace rsh
