/* types.h - how kernels read the caller's mesh; shared by host and device. */
#ifndef RSH_MESH_TYPES_H
#define RSH_MESH_TYPES_H

#include "rsh/rsh_types.h"

/* How to read rsh_geometry, and the normals of an rsh_scene: offsets and strides in words of 4 bytes. */
typedef struct mesh_view {
    rsh_uint vertices_first_low, vertices_first_high;
    rsh_uint indices_first_low, indices_first_high;
    rsh_uint vertex_stride;
    rsh_uint vertex_count;
    rsh_uint triangle_count;
    rsh_uint is_indexed;
    rsh_uint normals_first_low, normals_first_high;
    rsh_uint normal_stride;
    rsh_uint features; /* of the scene: RSH_IN_SCENE_... */
} mesh_view;
RSH_ASSERT_SIZE(mesh_view, 48);

/* Features that programs look for in a scene: RSH_FEATURE_... of rsh.h. */
#define RSH_IN_SCENE_REFRACTION 0x02u
#define RSH_IN_SCENE_TEXTURE 0x08u
#define RSH_IN_SCENE_SMOOTH_NORMAL 0x10u
#define RSH_IN_SCENE_ENVIRONMENT_IMAGE 0x20u

/* Sides of triangles that are not hit: RSH_CULL_... of rsh.h. */
#define RSH_CULLED_BACK 1u
#define RSH_CULLED_FRONT 2u

#endif
