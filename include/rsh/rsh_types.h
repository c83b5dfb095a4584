/* rsh_types.h - the structs that callers put into buffers or read there, written once.
 *
 * Read by C99, C++11 and OpenCL C: scalars and 4-vectors only (a 3-vector occupies four
 * components on the device), padding spelled out, sizes asserted in all three languages.
 * Declares no function; rsh.h is the API.
 *
 * These sizes are final. Words called `reserved` must be 0; a later version may give them a
 * meaning, and 0 will then mean what this version does.
 */
#ifndef RSH_TYPES_H
#define RSH_TYPES_H

#ifdef __OPENCL_VERSION__
typedef float4 rsh_float4;
typedef float rsh_float;
typedef uint rsh_uint;
typedef ulong rsh_ulong;
#else
#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#ifdef __APPLE__
#include <OpenCL/cl.h>
#else
#include <CL/cl.h>
#endif
typedef cl_float4 rsh_float4;
typedef cl_float rsh_float;
typedef cl_uint rsh_uint;
typedef cl_ulong rsh_ulong;
#endif

#define RSH_ASSERT_SIZE(type, bytes) \
    typedef char type##_is_##bytes##_bytes[sizeof(type) == (bytes) ? 1 : -1]

/* rsh_hit::primitive of a ray that hits nothing. */
#define RSH_NO_HIT 0xffffffffu

/* In place of the number of a ray: there is none, see rsh_spawn_wave. */
#define RSH_NO_RAY 0xffffffffu

/* rsh_material::texture of a material without a texture. */
#define RSH_NO_TEXTURE 0xffffffffu

/* Lights of one scene: one bit each in the occlusion mask of a ray. */
#define RSH_MAX_LIGHTS 32

/* Levels of a hierarchy: 4^14 rays fill 15 levels, a list of 2^28 rays as well. */
#define RSH_MAX_LEVELS 16

/* Bits of rsh_statistics::wrong_buffers: what a traversal met that was not made for it. */
#define RSH_WRONG_BOUNDS 1u
#define RSH_WRONG_NODES 2u

/* A ray: the points origin + t * direction with tmin <= t <= tmax; a tmin below 0 counts as 0.
 *
 * The direction has any length but zero, within limits (rsh_traverse); t counts in units of that
 * length. A ray is inactive, costs nothing in the hierarchy and hits nothing, when a component of
 * its origin or direction is not finite, its direction is zero, tmin or tmax is NaN, or tmax is
 * below tmin. */
typedef struct rsh_ray {
    rsh_float4 origin_tmin;    /* xyz: origin [world], w: tmin    */
    rsh_float4 direction_tmax; /* xyz: direction [world], w: tmax */
} rsh_ray;
RSH_ASSERT_SIZE(rsh_ray, 32);

/* The closest hit of a ray: (1 - u - v) * vertex 0 + u * vertex 1 + v * vertex 2.
 * Without a hit: primitive = RSH_NO_HIT, t = tmax of the ray, u = v = 0. */
typedef struct rsh_hit {
    rsh_float t;
    rsh_float u;
    rsh_float v;
    rsh_uint primitive; /* index of the triangle */
} rsh_hit;
RSH_ASSERT_SIZE(rsh_hit, 16);

/* Which triangles of an rsh_geometry are one of its meshes: those from first_triangle on, up to the next
 * range's. Ranges ascend and begin with triangle 0; in what other order they come, or which numbers they
 * have, is not found out: a triangle then is of any of them. Of ranges that begin together the last one
 * has the triangles. */
typedef struct rsh_mesh_range {
    rsh_uint first_triangle;
    rsh_uint id;       /* any number of the caller's                        */
    rsh_uint mask;     /* which rays hit it: ray_masks of rsh_traverse_desc */
    rsh_uint reserved; /* 0 */
} rsh_mesh_range;
RSH_ASSERT_SIZE(rsh_mesh_range, 16);

/* What a ray hits, for shading: see rsh_find_surfaces. Where an active ray hits nothing, or a triangle
 * without a normal, and for inactive rays: primitive = RSH_NO_HIT, all else 0. */
typedef struct rsh_surface {
    rsh_float4 point;     /* xyz: on the triangle [world], w: t of the hit                      */
    rsh_float4 geometric; /* xyz: unit normal of the triangle, turned to the side that the ray
                             comes from; w: 1 when that is the outside, see rsh_material, or -1 */
    rsh_float4 normal;    /* xyz: unit normal for shading, turned to that same side; w: 0       */
    rsh_float4 texture;   /* rgb: linear colour of the material's texture, without one 1; w: 0  */
    rsh_float texture_u;  /* texture coordinates; 0 where the scene has none                    */
    rsh_float texture_v;
    rsh_uint material;    /* its number, below material_count                                   */
    rsh_uint primitive;   /* index of the triangle                                              */
} rsh_surface;
RSH_ASSERT_SIZE(rsh_surface, 80);

/* What an audit found: see rsh_audit. */
typedef struct rsh_audit_report {
    rsh_ulong rays;        /* that were traced again                                   */
    rsh_ulong differences; /* of these, with an answer that is not that of brute force */
    rsh_uint first_ray;    /* lowest index of such a ray; RSH_NO_HIT: there is none    */
    /* The differences by kind; sums over more than 2^32 of them wrap. */
    rsh_uint missed;   /* no hit, or a farther one, where brute force hits       */
    rsh_uint spurious; /* a hit, or a nearer one, where brute force has none     */
    rsh_uint wrong;    /* another triangle, u or v at the right t; a miss not as in rsh_hit */
} rsh_audit_report;
RSH_ASSERT_SIZE(rsh_audit_report, 32);

/* Pinhole camera. Pixel (x, y), y downwards, looks from `eye` along
 *   forward + ((x + 0.5) / width * 2 - 1) * right + (1 - (y + 0.5) / height * 2) * up,
 * normalised; so |right| / |forward| is the tangent of half the horizontal field of view. */
typedef struct rsh_camera {
    rsh_float4 eye;     /* xyz [world], w: near, the tmin of primary rays [world] */
    rsh_float4 forward; /* xyz, w: far, their tmax [world]; 0: infinite            */
    rsh_float4 right;   /* xyz, w: 0 */
    rsh_float4 up;      /* xyz, w: 0 */
    rsh_uint reserved[8]; /* 0; for an aperture, a focus, samples and a shutter */
} rsh_camera;
RSH_ASSERT_SIZE(rsh_camera, 96);

/* Whitted's material (CACM 1980), with Blinn-Phong highlights. All colours are linear.
 * A surface sends out  emission + ambient * scene ambient
 *   + for each light that reaches it: colour that arrives
 *     * (diffuse * cos(normal, to light) + specular * cos(normal, halfway to viewer)^shininess)
 *   + reflected weight * what the mirror ray sees + refracted weight * what the refracted ray
 *   sees.
 * The geometric normal n = (v1 - v0) x (v2 - v0) points to the outside. For shading it is
 * turned to the side that the ray comes from, and replaced by the interpolated vertex normal,
 * turned to that same side, unless this one is zero. A light reaches the surface when both
 * normals face it. With transmission, the weights follow Fresnel's reflectance F of an
 * unpolarized dielectric: reflected F + (1 - F) * reflection, refracted (1 - F) * transmission;
 * F = 1 under total internal reflection. Without transmission the reflected weight is
 * `reflection`. */
typedef struct rsh_material {
    rsh_float4 ambient;      /* rgb, w: 0; multiplied by the texture */
    rsh_float4 diffuse;      /* rgb, w: 0; multiplied by the texture */
    rsh_float4 specular;     /* rgb, w: shininess, the Blinn-Phong exponent */
    rsh_float4 reflection;   /* rgb, w: 0 */
    rsh_float4 transmission; /* rgb, w: index of refraction inside, relative to outside;
                                not positive, infinite or NaN: 1 */
    rsh_float4 emission;     /* rgb, w: 0 */
    rsh_uint texture;        /* of the ambient and diffuse colours, or RSH_NO_TEXTURE */
    rsh_uint reserved[7];    /* 0; for roughness, the priority of nested media, cut-outs and more
                                textures */
} rsh_material;
RSH_ASSERT_SIZE(rsh_material, 128);

#define RSH_LIGHT_POINT 0u
#define RSH_LIGHT_DIRECTIONAL 1u
#define RSH_LIGHT_SPOT 2u

typedef struct rsh_light {
    rsh_float4 position;    /* point, spot: xyz [world], w: 0 */
    rsh_float4 direction;   /* directional, spot: xyz, unit, the way the light travels; w: 0 */
    rsh_float4 colour;      /* rgb, linear; w: 0 */
    rsh_float4 attenuation; /* colour / (x + y * distance + z * distance^2); all 0: none;
                               a sum that is not positive: no light arrives */
    rsh_float cos_inner;    /* spot: full colour inside this cone, ... */
    rsh_float cos_outer;    /* ... none outside this one, smoothstep between */
    rsh_uint kind;          /* RSH_LIGHT_... */
    rsh_uint casts_shadow;  /* 0 or 1 */
    rsh_uint reserved[12];  /* 0; for the extent of lights and their samples */
} rsh_light;
RSH_ASSERT_SIZE(rsh_light, 128);

#define RSH_TEXEL_SRGB8 0u   /* 4 bytes r g b a, sRGB-encoded */
#define RSH_TEXEL_FLOAT32 1u /* 4 floats r g b a, linear       */

#define RSH_WRAP_REPEAT 0u
#define RSH_WRAP_CLAMP 1u /* outside of 0 .. 1 there is the colour of the edge */

/* One image in the texel buffer; rows from top to bottom, v = 1 is the top edge. Texels are
 * decoded, then interpolated between their centres (bilinear); a is ignored.
 * As a latitude-longitude image, a unit direction (x, y, z) looks at
 *   u = 0.5 + atan2(x, -z) / (2 pi),  v = 0.5 + asin(y) / pi
 * and the image repeats in u only, whatever `wrap` is: the middle is -z, the top +y. */
typedef struct rsh_texture {
    rsh_uint first_word; /* offset in the texel buffer, in units of 4 bytes */
    rsh_uint width;
    rsh_uint height;
    rsh_uint format; /* RSH_TEXEL_... */
    rsh_uint wrap;   /* RSH_WRAP_...; other values repeat */
    rsh_uint reserved[7]; /* 0; for scale, shift and another filter */
} rsh_texture;
RSH_ASSERT_SIZE(rsh_texture, 48);

#endif /* RSH_TYPES_H */
