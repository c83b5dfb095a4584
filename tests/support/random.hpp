// random.hpp - the numbers that tests draw. One seed for the whole run, RSH_SEED or 1, so that
// a failure can be drawn again; a test mixes in its own salt so that tests do not share a
// sequence. The same on every platform: no std distribution, their algorithms are not
// specified.
#pragma once

#include <cstdint>
#include <random>

#include "support/vec.hpp"

namespace test {

uint64_t seed();

// RSH_TEST_SMALL is set: the device is an emulator, and sizes shrink to what it can bear.
bool small();

class Random {
public:
    explicit Random(uint64_t salt) : engine_(seed() * 0x9e3779b97f4a7c15u + salt) {}

    uint64_t bits() { return engine_(); }
    uint32_t below(uint32_t limit) { return uint32_t((bits() >> 32) * limit >> 32); }
    float unit() { return float(bits() >> 40) * 0x1p-24f; }
    float between(float low, float high) { return low + (high - low) * unit(); }
    bool chance(float probability) { return unit() < probability; }

    Float3 in_cube(float half = 1.0f) {
        return {between(-half, half), between(-half, half), between(-half, half)};
    }

    // Not normalised: lengths in [0.1, 1], as a caller may pass them.
    Float3 direction() {
        for (;;) {
            const Float3 d = in_cube();
            const float length2 = dot(d, d);
            if (length2 > 0.01f && length2 <= 1.0f) return d;
        }
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace test
