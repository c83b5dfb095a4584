/* lanes.h - floatv, intv, uintv: RSH_WIDTH elements that one work-item handles at once.
 * Compilers for CPUs hardly vectorize across work-items with branches, so the width is written
 * out. The operators mean the same for every width: comparisons give a mask for select() and
 * any_lane(). */
#ifndef RSH_LANES_LANES_H
#define RSH_LANES_LANES_H

#ifdef __clang__
/* All functions are static: how they hand wide vectors over concerns no other compiler. */
#pragma clang diagnostic ignored "-Wpsabi"
#endif

/* a * b + c stays two roundings unless fma is called by name: same bits on every device. */
#pragma OPENCL FP_CONTRACT OFF

#ifndef RSH_WIDTH
#define RSH_WIDTH 1
#endif

/* Before a kernel whose work-items fill vector registers themselves: what each does is as wide as a float16.
 * A compiler that packs work-items into the lanes of vectors is to leave such a kernel alone. Intel's for CPUs
 * does not see it by itself: it took ten times as long for rsh_cut and rsh_traverse_tiles, and the second one
 * got 604 KB of private memory instead of 36 KB. With one lane, packing is what fills the registers. */
#if RSH_WIDTH > 1
#define RSH_FILLS_VECTORS __attribute__((vec_type_hint(float16)))
#else
#define RSH_FILLS_VECTORS
#endif

/* Before a function: it is called, not copied into its callers. PoCL compiles the body of a kernel three
 * times, once for each way to launch it, but what the body calls only once. On GPUs calls are dear, and
 * bodies are compiled once: there it means nothing. Called functions ask for no numbers of work-items:
 * drivers know these in kernels and what is copied into them. */
#if RSH_WIDTH > 1
#define RSH_CALLED __attribute__((noinline))
#else
#define RSH_CALLED
#endif

#if RSH_WIDTH == 1
typedef float floatv;
typedef int intv;
typedef uint uintv;
#define as_intv as_int
#define as_floatv as_float
#define as_uintv as_uint
#define convert_intv convert_int
#define store_lanes(value, array) ((array)[0] = (value))
#define load_lanes(array) ((array)[0])
#define any_lane(mask) (mask)
#else
#define RSH_JOIN_(a, b) a##b
#define RSH_JOIN(a, b) RSH_JOIN_(a, b)
typedef RSH_JOIN(float, RSH_WIDTH) floatv;
typedef RSH_JOIN(int, RSH_WIDTH) intv;
typedef RSH_JOIN(uint, RSH_WIDTH) uintv;
#define as_intv RSH_JOIN(as_int, RSH_WIDTH)
#define as_floatv RSH_JOIN(as_float, RSH_WIDTH)
#define as_uintv RSH_JOIN(as_uint, RSH_WIDTH)
#define convert_intv RSH_JOIN(convert_int, RSH_WIDTH)
#define store_lanes(value, array) RSH_JOIN(vstore, RSH_WIDTH)(value, 0, array)
#define load_lanes(array) RSH_JOIN(vload, RSH_WIDTH)(0, array)
#define any_lane(mask) (RSH_LANE_BITS(mask) != 0)
#endif

/* store_lanes in one instruction, to __global or __private memory: vstore may be split into
 * several stores, and many of these fill a CPU's store buffer. */
typedef floatv __attribute__((aligned(4))) floatv_anywhere;
typedef uintv __attribute__((aligned(4))) uintv_anywhere;
#define store_whole(space, value, array) (*(space floatv_anywhere*)(array) = (value))
#define store_whole_uint(space, value, array) (*(space uintv_anywhere*)(array) = (value))

/* The number of each lane. */
#if RSH_WIDTH == 1
#define RSH_LANES ((intv)(0))
#elif RSH_WIDTH == 4
#define RSH_LANES ((intv)(0, 1, 2, 3))
#elif RSH_WIDTH == 8
#define RSH_LANES ((intv)(0, 1, 2, 3, 4, 5, 6, 7))
#else
#define RSH_LANES ((intv)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))
#endif

/* RSH_LANE_BITS: bit i is lane i of a mask. A CPU does it in one instruction, plain OpenCL C in
 * a tree of them; clang, and so PoCL, lets kernels name the instructions of their target. */
#ifdef __has_builtin
#if RSH_WIDTH > 1 && __has_builtin(__builtin_prefetch)
/* Asks for a cache line that will be written, or read. */
#define RSH_EXPECT_STORE(at) __builtin_prefetch((const void*)(ulong)(at), 1)
#define RSH_EXPECT_LOAD(at) __builtin_prefetch((const void*)(ulong)(at), 0)
#endif
#if RSH_WIDTH > 1 && __has_builtin(__builtin_nontemporal_store)
/* Stores a vector, where it is aligned, past the caches: what was there is not read from memory first. */
#define RSH_STORE_PAST_CACHES(value, at) __builtin_nontemporal_store(value, at)
#endif
#if RSH_WIDTH == 16 && __has_builtin(__builtin_ia32_cvtd2mask512) && defined(__AVX512DQ__)
#define RSH_LANE_BITS(mask) ((uint)(ushort)__builtin_ia32_cvtd2mask512(mask))
#elif RSH_WIDTH == 8 && __has_builtin(__builtin_ia32_movmskps256) && defined(__AVX__)
#define RSH_LANE_BITS(mask) ((uint)__builtin_ia32_movmskps256(as_float8(mask)))
#endif
#endif
#ifndef RSH_STORE_PAST_CACHES
#define RSH_STORE_PAST_CACHES(value, at) (*(at) = (value))
#endif
#ifndef RSH_EXPECT_LOAD
#define RSH_EXPECT_STORE(at) (void)(at)
#define RSH_EXPECT_LOAD(at) (void)(at)
#endif
#ifndef RSH_LANE_BITS
#define RSH_LANE_BITS(mask) lane_bits_by_tree(mask)
#if RSH_WIDTH == 1
static uint lane_bits_by_tree(intv mask) { return mask != 0; }
#elif RSH_WIDTH == 4
static uint lane_bits_by_tree(int4 mask)
{
    const int4 bits = mask & (int4)(1, 2, 4, 8);
    const int2 two = bits.lo | bits.hi;
    return (uint)(two.x | two.y);
}
#else
static uint lane_bits_of_8(int8 mask)
{
    const int8 bits = mask & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    const int4 four = bits.lo | bits.hi;
    const int2 two = four.lo | four.hi;
    return (uint)(two.x | two.y);
}
#if RSH_WIDTH == 8
static uint lane_bits_by_tree(int8 mask) { return lane_bits_of_8(mask); }
#else
static uint lane_bits_by_tree(int16 mask)
{
    return lane_bits_of_8(mask.lo) | lane_bits_of_8(mask.hi) << 8;
}
#endif
#endif
#endif

/* The mask that has these bits. */
static intv mask_of_bits(uint bits)
{
    return (((intv)((int)bits) >> RSH_LANES) & (intv)(1)) != (intv)(0);
}

#endif
