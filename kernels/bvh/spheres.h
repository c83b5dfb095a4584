/* spheres.h - spheres around the triangles as rsh_bound leaves them: a head, then one each. */
#ifndef RSH_BVH_SPHERES_H
#define RSH_BVH_SPHERES_H

#include "bvh/types.h"

#define RSH_SPHERES_AT 4 /* float4s */

static void write_spheres_head(uint triangles, __global float4* bounds)
{
    __global spheres_head* head = (__global spheres_head*)bounds;
    head->made = RSH_SPHERES_MADE;
    head->triangles = triangles;
}

static bool spheres_are_of(uint triangles, __global const float4* bounds)
{
    __global const spheres_head* head = (__global const spheres_head*)bounds;
    return head->made == RSH_SPHERES_MADE && head->triangles == triangles;
}

#endif
