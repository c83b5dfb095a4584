/* range.h - what one work-item does with a range of elements, whatever the strategy:
 *   kept_lanes  bit k: element i + k is kept; i + 15 must be in the stream, i a multiple of 16
 *   count_range   how many of the range are kept
 *   pack_range    stores the kept ones, `kept` as counted, at output[at ...]; touches no other
 *               element, so that work-items with neighbouring outputs do not disturb each other
 * Ranges begin at multiples of RSH_RANGE_STEP. With vector compress instructions in the device's
 * instruction set, and a compiler that lets them be named, sixteen elements go at a time.
 */
#ifndef RSH_REDUCE_RANGE_H
#define RSH_REDUCE_RANGE_H

#include "reduce/range_compress.h"
#include "reduce/range_scalar.h"

#endif
