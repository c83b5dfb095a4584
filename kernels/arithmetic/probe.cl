/* probe.cl - does the operations that hits rest on, for the host to compare (lib/arithmetic/).
 * Operands come from memory, so that no compiler knows them.
 *   operands  in   rows of a, b, c and d, `count` each, a multiple of 16
 *   results   out  the bits of RSH_PROBE_ROWS rows of as many
 * rsh_probe does one of each row at a time, rsh_probe_lanes a vector: compilers treat them apart.
 */
#include "arithmetic/types.h"
#include "lanes/lanes.h"

#define LOAD_ONE(array) ((array)[0])
#define STORE_ONE(value, array) ((array)[0] = (value))

#define RELATION(I, condition, bit) select((I)(0), (I)(bit), condition)

#define DEFINE_PROBE(name, F, I, FLOAT_OF_INT, LANES, LOAD, STORE)                        \
    __kernel void name(__global const float* operands, uint count, __global int* results) \
    {                                                                                     \
        const uint at = (uint)get_global_id(0) * LANES;                                   \
        if (at >= count) return; /* launch is rounded up to whole groups */               \
        __global const float* const from = operands + at;                                 \
        const F a = LOAD(from), b = LOAD(from + count);                                   \
        const F c = LOAD(from + 2 * count), d = LOAD(from + 3 * count);                   \
        __global int* const to = results + at;                                            \
        const F sum = a + b, product = a * b;                                             \
        STORE(as_##I(sum), to + RSH_PROBE_SUM * count);                                   \
        STORE(as_##I(a - b), to + RSH_PROBE_DIFFERENCE * count);                          \
        STORE(as_##I(product), to + RSH_PROBE_PRODUCT * count);                           \
        const F b_added = sum - a;                                                        \
        const F sum_rest = (a - (sum - b_added)) + (b - b_added);                         \
        STORE(as_##I(sum_rest), to + RSH_PROBE_SUM_REST * count);                         \
        const F product_plus = a * b + c, two_products = a * b - c * d;                   \
        STORE(as_##I(product_plus), to + RSH_PROBE_PRODUCT_PLUS * count);                 \
        STORE(as_##I(c - a * b), to + RSH_PROBE_MINUS_PRODUCT * count);                   \
        STORE(as_##I(two_products), to + RSH_PROBE_TWO_PRODUCTS * count);                 \
        STORE(as_##I(fma(a, b, c)), to + RSH_PROBE_FMA * count);                          \
        STORE(as_##I(fma(-a, b, c)), to + RSH_PROBE_FMA_NEGATED * count);                 \
        STORE(as_##I(fma(a, b, -product)), to + RSH_PROBE_PRODUCT_REST * count);          \
        STORE(as_##I(a / b), to + RSH_PROBE_QUOTIENT * count);                            \
        STORE(as_##I((F)(1.0f) / b), to + RSH_PROBE_RECIPROCAL * count);                  \
        STORE(as_##I(sqrt(a)), to + RSH_PROBE_ROOT * count);                              \
        STORE(as_##I(fmin(a, b)), to + RSH_PROBE_LESSER * count);                         \
        STORE(as_##I(fmax(a, b)), to + RSH_PROBE_GREATER * count);                        \
        const I relations = RELATION(I, a < b, RSH_PROBE_IS_LESS) |                       \
                            RELATION(I, a <= b, RSH_PROBE_IS_AT_MOST) |                   \
                            RELATION(I, a > b, RSH_PROBE_IS_MORE) |                       \
                            RELATION(I, a >= b, RSH_PROBE_IS_AT_LEAST) |                  \
                            RELATION(I, a == b, RSH_PROBE_IS_EQUAL) |                     \
                            RELATION(I, a != b, RSH_PROBE_IS_OTHER) |                     \
                            RELATION(I, isnan(a), RSH_PROBE_IS_NAN) |                     \
                            RELATION(I, isinf(a), RSH_PROBE_IS_INFINITE) |                \
                            RELATION(I, isfinite(a), RSH_PROBE_IS_FINITE);                \
        STORE(relations, to + RSH_PROBE_RELATIONS * count);                               \
        STORE(as_##I(FLOAT_OF_INT(as_##I(a))), to + RSH_PROBE_FLOAT_OF_INT * count);      \
        STORE(convert_##I(a), to + RSH_PROBE_INT_OF_FLOAT * count);                       \
        STORE(as_##I(floor(a)), to + RSH_PROBE_FLOOR * count);                            \
    }

DEFINE_PROBE(rsh_probe, float, int, convert_float, 1, LOAD_ONE, STORE_ONE)
#if RSH_WIDTH > 1
#define FLOATV_OF_INTV RSH_JOIN(convert_float, RSH_WIDTH)
DEFINE_PROBE(rsh_probe_lanes, floatv, intv, FLOATV_OF_INTV, RSH_WIDTH, load_lanes, store_lanes)
#endif
