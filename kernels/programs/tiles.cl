/* tiles.cl - what the engine `tiles` launches, as one program; see programs/paper_faithful.cl
 * for why. */
#include "bvh/join.cl"
#include "bvh/leaves.cl"
#include "bvh/nodes.cl"
#include "bvh/order.cl"
#include "bvh/refit.cl"
#include "order/sort.cl"
#include "rays/build_boxes.cl"
#include "rays/sort_rays.cl"
#include "traverse/tiles/traverse_tiles.cl"
