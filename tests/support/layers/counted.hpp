// counted.hpp - what the layer of counts.cpp counts while a test does something. Throws without the
// layer.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "support/layers/counts.hpp"

namespace test {

template <class Function>
Function of_layer(const char* name) {
    void* const library = dlopen(RSH_COUNTS_LAYER, RTLD_NOW | RTLD_NOLOAD);
    void* const found = library ? dlsym(library, name) : nullptr;
    if (!found)
        throw std::runtime_error("the loader has not taken OPENCL_LAYERS " RSH_COUNTS_LAYER);
    Function function = nullptr;
    std::memcpy(&function, &found, sizeof function);
    return function;
}

inline rsh_counts counts_now() {
    rsh_counts counts = {};
    of_layer<rsh_read_counts_function>("rsh_read_counts")(&counts);
    return counts;
}

// Counted since it was made. What is alive may be less than then: the difference wraps.
class Since {
public:
    rsh_counts now() const {
        rsh_counts counts = counts_now();
#define RSH_SUBTRACT(name) counts.name -= begin_.name;
        RSH_COUNTS(RSH_SUBTRACT)
#undef RSH_SUBTRACT
        return counts;
    }

private:
    rsh_counts begin_ = counts_now();
};

inline void expect_nothing_made(const rsh_counts& counts) {
    EXPECT_EQ(counts.buffers, 0u);
    EXPECT_EQ(counts.compiles, 0u);
    EXPECT_EQ(counts.binary_builds, 0u);
    EXPECT_EQ(counts.kernels, 0u);
}

}  // namespace test
