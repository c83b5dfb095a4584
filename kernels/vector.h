/* vector.h - floatv, intv, uintv: RSH_WIDTH elements that one work-item handles at once.
 * Compilers for CPUs hardly vectorize across work-items with branches, so the width is written
 * out. The operators mean the same for every width: comparisons give a mask for select() and
 * any_lane(). */
#ifndef RSH_VECTOR_H
#define RSH_VECTOR_H

/* a * b + c stays two roundings unless fma is called by name: same bits on every device. */
#pragma OPENCL FP_CONTRACT OFF

#ifndef RSH_WIDTH
#define RSH_WIDTH 1
#endif

#if RSH_WIDTH == 1
typedef float floatv;
typedef int intv;
typedef uint uintv;
#define as_intv as_int
#define as_floatv as_float
#define as_uintv as_uint
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
#define store_lanes(value, array) RSH_JOIN(vstore, RSH_WIDTH)(value, 0, array)
#define load_lanes(array) RSH_JOIN(vload, RSH_WIDTH)(0, array)
#define any_lane(mask) any(mask)
#endif

#endif
