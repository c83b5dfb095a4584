/* approximate.cl - what approximate frames launch beside the rest, as one program: other frames do not
 * build it. */
#include "approximate/blend.cl"
#include "approximate/take_pixels.cl"
