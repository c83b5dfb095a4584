// checksum.cpp - Fowler, Noll and Vo's hash, variant 1a.
#include "frame/checksum.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace bench {

std::string checksum(const unsigned char* bytes, size_t count) {
    uint64_t hash = 0xcbf29ce484222325;
    for (size_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

}  // namespace bench
