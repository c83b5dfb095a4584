/* paper.cl - what the engine `paper` launches, and with RSH_FITTED the bound
 * `cone_fitted`, as one program; see programs/paper_faithful.cl for why. */
#include "traverse/paper/traverse_runs.cl"
#include "traverse/paper/intersect_runs.cl"
#include "reduce/scan_counts.cl"
#if RSH_FITTED
#include "bvh/spheres.cl"
#include "rays/build_fitted_cones.cl"
#else
#include "rays/join_boxes.cl"
#endif
