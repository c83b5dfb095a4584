/* program_traverse.cl - what every traversal launches, as one program: compiling a program costs PoCL
 * about 0.3 s before the first line of it, so kernels that are needed together are built together.
 */
#include "bound.cl"
#include "build.cl"
#include "traverse_test.cl"
#include "traverse_walk.cl"
#include "intersect.cl"
#include "resolve.cl"
