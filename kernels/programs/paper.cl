/* paper.cl - what the engine `paper` launches, as one program; see programs/paper_faithful.cl
 * for why. */
#include "rays/join_boxes.cl"
#include "reduce/scan_counts.cl"
#include "traverse/clear_hits.cl"
#include "traverse/paper/intersect_ranges.cl"
#include "traverse/paper/traverse_ranges.cl"
