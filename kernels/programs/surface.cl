/* surface.cl - what happens at a hit, as one program; see programs/paper_faithful.cl for
 * why. */
#include "reduce/scan_counts.cl"
#include "shade/clear_colour.cl"
#include "shade/cut.cl"
#include "shade/find_surfaces.cl"
#include "shade/shade.cl"
#include "shade/shade_lit.cl"
#include "shade/spawn.cl"
#include "shade/spawn_shadow.cl"
#include "shade/wave.cl"
#include "shade/wave_origins.cl"
