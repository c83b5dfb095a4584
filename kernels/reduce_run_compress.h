/* reduce_run_compress.h - runs by vector compress (AVX-512F, with DQ and BMI2); see
 * reduce_run.h.
 *
 * Sixteen elements are RSH_WORDS vectors of sixteen words. A word is kept if its element is:
 * bit k of kept_lanes, deposited at bit RSH_WORDS * k, times 2^RSH_WORDS - 1, is a mask over
 * all these words, and each vector takes its sixteen bits of it. Three words, elements 0 and 2
 * kept:  lanes 101  ->  1 000 001  ->  times 7: 111 000 111. A store under a mask writes the
 * kept words and nothing behind them, so that work-items never meet.
 */
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
#if RSH_KEEP == 0
    const char16 is_kept = vload16(0, flags + i) != (uchar16)(0);
    return (ushort)__builtin_ia32_pmovmskb128(is_kept);
#elif RSH_KEEP == 1
    ulong words = 0;
    for (uint v = 0; v < RSH_WORDS; ++v) {
        const int16 is_kept = load_words(input, i, v) != (int16)(RSH_NO_HIT);
        words |= (ulong)(ushort)__builtin_ia32_cvtd2mask512(is_kept) << 16 * v;
    }
    return (uint)__builtin_ia32_pext_di(words, RSH_FIRST_WORDS);
#else
    const uchar2 bytes = vload2(0, flags + i / 8);
    return bytes.x | (uint)bytes.y << 8;
#endif
}

static uint count_run(__global const uint* input, __global const uchar* flags, rsh_run run)
{
    uint kept = 0, i = run.begin;
    for (; i + 16 <= run.end; i += 16) kept += popcount(kept_lanes(input, flags, i));
    for (; i < run.end; ++i) kept += is_kept(input, flags, i);
    return kept;
}

static void pack_run(__global const uint* input, __global const uchar* flags, rsh_run run,
                     uint kept, __global uint* output, uint at)
{
    if (kept == 0) return;
    __global int* to = (__global int*)(output + (ulong)RSH_WORDS * at);
    uint i = run.begin;
    for (; i + 16 <= run.end; i += 16) {
        const uint lanes = kept_lanes(input, flags, i);
        const ulong words =
            __builtin_ia32_pdep_di(lanes, RSH_FIRST_WORDS) * ((1u << RSH_WORDS) - 1);
        for (uint v = 0; v < RSH_WORDS; ++v) {
            const uint mask = (ushort)(words >> 16 * v), taken = popcount(mask);
            const int16 all = load_words(input, i, v);
            const int16 packed = __builtin_ia32_compresssi512_mask(all, all, (ushort)mask);
            __builtin_ia32_storedqusi512_mask(to, packed, (ushort)((1u << taken) - 1));
            to += taken;
        }
    }
    __global uint* rest = (__global uint*)to;
    for (uint at_rest = 0; i < run.end; ++i)
        if (is_kept(input, flags, i)) {
            store_element(load_element(i, input), at_rest, rest);
            ++at_rest;
        }
}
