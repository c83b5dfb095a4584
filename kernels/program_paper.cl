/* program_paper.cl - what the engine `paper` launches, and with RSH_FITTED the bound
 * `cone_fitted`, as one program; see program_traverse.cl for why. */
#include "traverse_runs.cl"
#include "intersect_runs.cl"
#include "reduce_scan_counts.cl"
#if RSH_FITTED
#include "bound.cl"
#include "build_cones.cl"
#else
#include "join_boxes.cl"
#endif
