/* program_surface.cl - what happens at a hit, as one program; see program_traverse.cl for
 * why. */
#include "spawn.cl"
#include "spawn_shadow.cl"
#include "shade.cl"
#include "clear_colour.cl"
