// random.cpp - reads RSH_SEED and RSH_TEST_SMALL, once.
#include "support/random.hpp"

#include <cstdlib>
#include <string>

namespace test {

uint64_t seed() {
    static const char* const text = std::getenv("RSH_SEED");
    static const uint64_t value = text ? std::strtoull(text, nullptr, 0) : 1;
    return value;
}

bool small() {
    static const char* const text = std::getenv("RSH_TEST_SMALL");
    return text && *text && std::string(text) != "0";
}

}  // namespace test
