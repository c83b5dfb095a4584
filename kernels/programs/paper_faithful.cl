/* paper_faithful.cl - what every traversal launches, as one program: compiling a program
 * costs PoCL about half a second before the first line of it, so kernels that are needed
 * together are built together. The reductions are those of pairs, the default element of
 * reduce/element.h.
 */
#include "bvh/spheres.cl"
#include "rays/build_cones.cl"
#include "reduce/chunk.cl"
#include "reduce/lookback.cl"
#include "traverse/clear_hits.cl"
#include "traverse/paper_faithful/intersect.cl"
#include "traverse/paper_faithful/resolve.cl"
#include "traverse/paper_faithful/traverse_level.cl"
#include "traverse/paper_faithful/traverse_walk.cl"
