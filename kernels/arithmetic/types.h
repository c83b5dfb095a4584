/* types.h - what arithmetic/probe.cl computes; shared by host and device. */
#ifndef RSH_ARITHMETIC_TYPES_H
#define RSH_ARITHMETIC_TYPES_H

/* A row of results each, of the operands a, b, c and d. */
enum probe_row {
    RSH_PROBE_SUM,
    RSH_PROBE_DIFFERENCE,
    RSH_PROBE_PRODUCT,
    RSH_PROBE_SUM_REST, /* what a + b lost to rounding */
    RSH_PROBE_PRODUCT_PLUS,
    RSH_PROBE_MINUS_PRODUCT,
    RSH_PROBE_TWO_PRODUCTS,
    RSH_PROBE_FMA,
    RSH_PROBE_FMA_NEGATED,
    RSH_PROBE_PRODUCT_REST, /* what a * b lost to rounding */
    RSH_PROBE_QUOTIENT,
    RSH_PROBE_RECIPROCAL,
    RSH_PROBE_ROOT,
    RSH_PROBE_LESSER,
    RSH_PROBE_GREATER,
    RSH_PROBE_RELATIONS,
    RSH_PROBE_FLOAT_OF_INT, /* of the bits of a */
    RSH_PROBE_INT_OF_FLOAT,
    RSH_PROBE_FLOOR,
    RSH_PROBE_ROWS
};

/* Bits of RSH_PROBE_RELATIONS: what holds between a and b, and of a. */
enum probe_relation {
    RSH_PROBE_IS_LESS = 1,
    RSH_PROBE_IS_AT_MOST = 2,
    RSH_PROBE_IS_MORE = 4,
    RSH_PROBE_IS_AT_LEAST = 8,
    RSH_PROBE_IS_EQUAL = 16,
    RSH_PROBE_IS_OTHER = 32,
    RSH_PROBE_IS_NAN = 64,
    RSH_PROBE_IS_INFINITE = 128,
    RSH_PROBE_IS_FINITE = 256
};

#endif
