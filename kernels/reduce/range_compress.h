/* range_compress.h - ranges by vector compress (AVX-512F, with DQ and BMI2); see
 * reduce/range.h.
 *
 * Sixteen elements are RSH_WORDS vectors of sixteen words. A word is kept if its element is:
 * bit k of kept_lanes, deposited at bit RSH_WORDS * k, times 2^RSH_WORDS - 1, is a mask over
 * all these words, and each vector takes its sixteen bits of it. Three words, elements 0 and 2
 * kept:  lanes 101  ->  1 000 001  ->  times 7: 111 000 111. A store under a mask writes the
 * kept words and nothing behind them, so that work-items never meet.
 */
#ifndef RSH_REDUCE_RANGE_COMPRESS_H
#define RSH_REDUCE_RANGE_COMPRESS_H

#include "reduce/stream_range.h"
#include "tuning.h"

#ifdef RSH_HAS_COMPRESS

#if RSH_WORDS == 1
#define RSH_FIRST_WORDS 0xffffUL
#elif RSH_WORDS == 2
#define RSH_FIRST_WORDS 0x55555555UL
#elif RSH_WORDS == 3
#define RSH_FIRST_WORDS 0x249249249249UL
#else
#define RSH_FIRST_WORDS 0x1111111111111111UL
#endif

static int16 load_words(__global const uint* input, uint i, uint vector)
{
    return vload16(0, (__global const int*)(input + (ulong)RSH_WORDS * i + 16 * vector));
}

static uint kept_lanes(__global const uint* input, __global const uchar* flags, uint i)
{
    if (RSH_KEEP == 0) {
        const char16 is_kept = vload16(0, flags + i) != (uchar16)(0);
        return (ushort)__builtin_ia32_pmovmskb128(is_kept);
    }
    if (RSH_KEEP != 1) {
        const uchar2 bytes = vload2(0, flags + i / 8);
        return bytes.x | (uint)bytes.y << 8;
    }
    ulong words = 0;
    for (uint v = 0; v < RSH_WORDS; ++v) {
        const int16 is_kept = load_words(input, i, v) != (int16)(RSH_NO_HIT);
        words |= (ulong)(ushort)__builtin_ia32_cvtd2mask512(is_kept) << 16 * v;
    }
    return (uint)__builtin_ia32_pext_di(words, RSH_FIRST_WORDS);
}

static uint count_range(__global const uint* input, __global const uchar* flags,
                        stream_range range)
{
    uint kept = 0, i = range.begin;
    for (; i + 16 <= range.end; i += 16) kept += popcount(kept_lanes(input, flags, i));
    for (; i < range.end; ++i) kept += is_kept(input, flags, i);
    return kept;
}

/* Packs elements begin .. end - 1, a multiple of 16 of them; returns how many words it kept. */
#define RSH_DEFINE_PACK(name, SPACE, STORE)                                               \
    static uint name(__global const uint* input, __global const uchar* flags, uint begin, \
                     uint end, SPACE int* to)                                             \
    {                                                                                     \
        uint stored = 0;                                                                  \
        for (uint i = begin; i < end; i += 16) {                                          \
            const uint lanes = kept_lanes(input, flags, i);                               \
            const ulong words =                                                           \
                __builtin_ia32_pdep_di(lanes, RSH_FIRST_WORDS) * ((1u << RSH_WORDS) - 1); \
            for (uint v = 0; v < RSH_WORDS; ++v) {                                        \
                const uint mask = (ushort)(words >> 16 * v), taken = popcount(mask);      \
                const int16 all = load_words(input, i, v);                                \
                STORE(__builtin_ia32_compresssi512_mask(all, all, (ushort)mask), taken,   \
                      to + stored);                                                       \
                stored += taken;                                                          \
            }                                                                             \
        }                                                                                 \
        return stored;                                                                    \
    }

#define RSH_LOW_LANES(count) ((ushort)((1u << (count)) - 1))

/* In place. Lines that will be written soon are asked for by then. */
#define RSH_STORE_IN_PLACE(packed, taken, to)         \
    __builtin_prefetch((to) + RSH_STORE_AHEAD, 1, 3); \
    __builtin_ia32_storedqusi512_mask(to, packed, RSH_LOW_LANES(taken))
RSH_DEFINE_PACK(pack_in_place, __global, RSH_STORE_IN_PLACE)

/* On a stage of one's own, where what lies behind the taken words does not matter. */
#define RSH_STORE_ON_STAGE(packed, taken, to) vstore16(packed, 0, to)
RSH_DEFINE_PACK(pack_on_stage, , RSH_STORE_ON_STAGE)

/* Packs on a stage in the nearest cache and stores whole lines past the caches: a line that is
 * stored to in place is first read from memory. Lines that begin or end outside of this range's
 * output are stored under a mask. Returns where the output goes on. */
static __global uint* pack_past_caches(__global const uint* input, __global const uchar* flags,
                                       uint begin, uint end, __global uint* to)
{
    int stage[RSH_WORDS * RSH_STAGE + 32] __attribute__((aligned(64)));
    uint first = (uint)((ulong)to / 4 % 16), filled = first; /* of the line, in words */
    __global int16* line = (__global int16*)(to - first);
    for (uint i = begin; i < end; i += RSH_STAGE) {
        filled += pack_on_stage(input, flags, i, min(i + RSH_STAGE, end), stage + filled);
        const uint lines = filled / 16;
        for (uint l = 0; l < lines; ++l)
            if (first == 0) {
                __builtin_nontemporal_store(vload16(l, stage), line + l);
            } else {
                __builtin_ia32_storedqusi512_mask((__global int*)(line + l), vload16(l, stage),
                                                  (ushort)~RSH_LOW_LANES(first));
                first = 0;
            }
        line += lines;
        vstore16(vload16(lines, stage), 0, stage);
        filled %= 16;
    }
    __builtin_ia32_storedqusi512_mask((__global int*)line, vload16(0, stage),
                                      RSH_LOW_LANES(filled) & ~RSH_LOW_LANES(first));
    return (__global uint*)line + filled;
}

static bool is_large(uint length) { return (ulong)RSH_WORDS * length >= RSH_LARGE_WORDS; }

static void pack_range(__global const uint* input, __global const uchar* flags,
                       stream_range range, uint kept, __global uint* output, uint at)
{
    if (kept == 0) return;
    __global uint* to = output + (ulong)RSH_WORDS * at;
    const uint whole = range.begin + (range.end - range.begin) / 16 * 16;
    if (is_large(range.length))
        to = pack_past_caches(input, flags, range.begin, whole, to);
    else
        to += pack_in_place(input, flags, range.begin, whole, (__global int*)to);
    for (uint i = whole, k = 0; i < range.end; ++i)
        if (is_kept(input, flags, i)) {
            store_element(load_element(i, input), k, to);
            ++k;
        }
}

#endif
#endif
