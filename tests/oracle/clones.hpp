// clones.hpp - RSH_TEST_CLONES: a function that the compiler vectorizes for several CPUs, of which the
// right one is taken when the program starts.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define RSH_TEST_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define RSH_TEST_CLONES
#endif
