/* program_traverse.cl - what every traversal launches, as one program: compiling a program
 * costs PoCL about half a second before the first line of it, so kernels that are needed
 * together are built together. The reductions are those of pairs, the default element of
 * reduce_element.h.
 */
#include "bound.cl"
#include "build.cl"
#include "traverse_test.cl"
#include "traverse_walk.cl"
#include "intersect.cl"
#include "resolve.cl"
#include "reduce_chunk.cl"
#include "reduce_lookback.cl"
