/* batch.h - programs whose triangles are one batch of a larger scene (RSH_BATCHES). In these, hits that
 * leave a kernel name triangles of the scene; within it, those of the batch. In other programs nothing is
 * left of it.
 */
#ifndef RSH_MESH_BATCH_H
#define RSH_MESH_BATCH_H

#ifndef RSH_BATCHES
#define RSH_BATCHES 0
#endif

#if RSH_BATCHES

typedef struct scene_batch {
    uint first_triangle; /* its number in the scene */
    uint is_continued;   /* answers hold those of other batches */
    /* The triangles that rays have left, of any batch: nine floats each, and their numbers in the scene.
     * 0: only the batch's own can have been left, and `skip` names them. */
    __global const float* skip_corners;
    __global const uint* skip_numbers;
    uint skip_count;
} scene_batch;

/* At the end of a kernel's parameters, and of a triangles_left. */
#define RSH_BATCH_PARAMETERS                                                      \
    , uint first_triangle, uint is_continued, __global const float *skip_corners, \
        __global const uint *skip_numbers, uint skip_count
#define RSH_GIVEN_BATCH \
    , { first_triangle, is_continued, skip_corners, skip_numbers, skip_count }

/* In place of the number of a triangle that is not of this batch. */
#define RSH_OTHER_BATCH 0xfffffffeu

static uint number_in_scene(const scene_batch* batch, uint triangle)
{
    return batch->first_triangle + triangle;
}

/* Of a hit that a triangle of this batch at the same t replaces only if its own number is lower. */
static uint rank_in_batch(const scene_batch* batch, uint number)
{
    return number < batch->first_triangle ? 0 : number - batch->first_triangle;
}

#else
#define RSH_BATCH_PARAMETERS
#define RSH_GIVEN_BATCH
#endif

#endif
