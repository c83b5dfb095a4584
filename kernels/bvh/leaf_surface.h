/* leaf_surface.h - the unit in which costs of leaves and nodes are counted (tuning.h). */
#ifndef RSH_BVH_LEAF_SURFACE_H
#define RSH_BVH_LEAF_SURFACE_H

#include "bvh/leaf_cuts.h"
#include "bvh/leaves.h"
#include "order/sort.h"
#include "tuning.h"

/* The surface of the scene's box by the number of leaves, about; never 0, so that a leaf always
 * costs something. */
RSH_CALLED static float leaf_surface_of(__global const sample_bounds* samples,
                                        uint sample_count, uint triangles)
{
    const sample_bounds scene = merged_bounds(samples, sample_count);
    const float surface = surface_of(scene.low, scene.high);
    return clamp(surface * RSH_MEAN_RANGE / (float)triangles, 1e-30f, RSH_MOST_SURFACE);
}

#endif
