/* run.h - what one work-item does with a run of elements, whatever the strategy:
 *   kept_lanes  bit k: element i + k is kept; i + 15 must be in the stream, i a multiple of 16
 *   count_run   how many of the run are kept
 *   pack_run    stores the kept ones, `kept` as counted, at output[at ...]; touches no other
 *               element, so that work-items with neighbouring outputs do not disturb each other
 * Runs begin at multiples of RSH_RUN_STEP. With vector compress instructions in the device's
 * instruction set, and a compiler that lets them be named, sixteen elements go at a time.
 */
#ifndef RSH_REDUCE_RUN_H
#define RSH_REDUCE_RUN_H

#include "reduce/run_compress.h"
#include "reduce/run_scalar.h"

#endif
