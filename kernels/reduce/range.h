/* range.h - what one work-item does with a range of elements, whatever the strategy:
 *   kept_lanes   bit k: element i + k is kept; i is a multiple of 16, i + 15 in the stream
 *   count_range  how many of the range are kept
 *   pack_range   stores the kept ones, `kept` as counted, at output[at ...]; touches no other
 *                element, so that work-items with neighbouring outputs do not meet
 * Ranges begin at multiples of RSH_RANGE_STEP. Where the device has instructions that compress
 * a vector, and the compiler lets them be named, sixteen elements go at a time.
 */
#ifndef RSH_REDUCE_RANGE_H
#define RSH_REDUCE_RANGE_H

#include "reduce/range_compress.h"
#include "reduce/range_scalar.h"

#endif
