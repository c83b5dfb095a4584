/* program_tiles.cl - what the engine `tiles` launches, as one program; see program_traverse.cl
 * for why. */
#include "bound_boxes.cl"
#include "refit_boxes.cl"
#include "order_triangles.cl"
#include "sort_rays.cl"
#include "sort.cl"
#include "build_boxes.cl"
#include "traverse_tiles.cl"
